#pragma once

/// For kernel files, after Highway has compiled them for every target: the table of one kernel's versions,
/// and the choice among them by name, call by call (Highway's own dispatch is one choice per process).

#include <hwy/highway.h>

#include "isa.hpp"

namespace velum {

/// A kernel's versions; nullptr where the build has none.
template <typename Function>
struct KernelVersions {
  Function emulated;
  Function sse4;
  Function avx2;
  Function avx512;
  Function neon;

  /// @pre is_available(isa), and not `reference`
  Function at(Isa isa) const {
    switch (isa == Isa::best ? best_isa() : isa) {
      case Isa::sse4:
        return sse4;
      case Isa::avx2:
        return avx2;
      case Isa::avx512:
        return avx512;
      case Isa::neon:
        return neon;
      default:
        return emulated;
    }
  }
};

}  // namespace velum

/// The versions of a function that stands in velum::HWY_NAMESPACE. For use in namespace velum, inside
/// `#if HWY_ONCE`.
#define VELUM_KERNEL_VERSIONS(function)                                                  \
  ::velum::KernelVersions<decltype(&HWY_STATIC_DISPATCH(function))> {                    \
    HWY_CHOOSE_FALLBACK(function), HWY_CHOOSE_SSE4(function), HWY_CHOOSE_AVX2(function), \
        HWY_CHOOSE_AVX3(function), HWY_CHOOSE_NEON(function)                             \
  }
