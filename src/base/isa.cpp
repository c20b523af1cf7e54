#include "isa.hpp"

#include <hwy/highway.h>

namespace velum {
namespace {

struct NamedIsa {
  Isa isa;
  const char* name;
  std::int64_t target;  ///< Highway's bit; 0: needs nothing
};

// From slow to fast.
constexpr NamedIsa isas[] = {{Isa::reference, "reference", 0},  {Isa::emulated, "emulated", 0},
                             {Isa::sse4, "sse4", HWY_SSE4},     {Isa::avx2, "avx2", HWY_AVX2},
                             {Isa::avx512, "avx512", HWY_AVX3}, {Isa::neon, "neon", HWY_NEON}};

/// What this machine has; asking the processor takes long.
std::int64_t machine_targets() {
  static const std::int64_t targets = HWY_TARGETS & hwy::SupportedTargets();
  return targets;
}

}  // namespace

bool is_available(Isa isa) {
  if (isa == Isa::best) return true;
  for (const NamedIsa& entry : isas) {
    if (entry.isa != isa) continue;
    return entry.target == 0 || (machine_targets() & entry.target) != 0;
  }
  return false;
}

std::vector<Isa> available_isas() {
  std::vector<Isa> available;
  for (const NamedIsa& entry : isas) {
    if (is_available(entry.isa)) available.push_back(entry.isa);
  }
  return available;
}

Isa best_isa() {
  Isa best = Isa::reference;
  for (const NamedIsa& entry : isas) {
    if (is_available(entry.isa)) best = entry.isa;
  }
  return best;
}

const char* name_of(Isa isa) {
  for (const NamedIsa& entry : isas) {
    if (entry.isa == isa) return entry.name;
  }
  return "best";
}

}  // namespace velum
