#include "elementary_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "base/elementary_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's header is read anew for every target; it must follow the line above.
#include <hwy/highway.h>

#include "elementary_vectors.hpp"
#include "simd_dispatch.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {

void pow_each(const double* x, const double* y, std::size_t count, double* out) {
  using namespace elementary_vectors;
  for (std::size_t i = 0; i < count; i += hn::Lanes(doubles))
    hn::StoreU(elementary_vectors::pow(hn::LoadU(doubles, x + i), hn::LoadU(doubles, y + i)), doubles,
               out + i);
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

PowEach pow_kernel(Isa isa) {
  static constexpr auto versions = VELUM_KERNEL_VERSIONS(pow_each);
  return versions.at(isa);
}

}  // namespace velum
#endif
