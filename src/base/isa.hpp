#pragma once

#include <vector>

namespace velum {

/// Which instructions the vectorized kernels use. Every choice gives the same bytes; see is_available() for
/// what this machine has.
enum class Isa {
  best,       ///< the fastest the machine has
  reference,  ///< no vector kernels: the plain loops they are tested against
  emulated,   ///< the vector kernels in plain C++
  sse4,
  avx2,
  avx512,
  neon,  ///< written for, not tried
};

/// Whether this build has kernels for the instruction set and this machine can run them.
bool is_available(Isa isa);

/// Every set that is_available() here, `best` left out; `reference` and `emulated` are always among them.
std::vector<Isa> available_isas();

/// What `best` stands for on this machine.
Isa best_isa();

/// "best", "reference", "emulated", "sse4", "avx2", "avx512", "neon"
const char* name_of(Isa isa);

}  // namespace velum
