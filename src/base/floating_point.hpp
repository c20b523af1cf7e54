#pragma once

#ifdef __FAST_MATH__
#error "velum promises the same bytes everywhere; it cannot keep that under -ffast-math. Build without it."
#endif

namespace velum {

/// Sets round-to-nearest-even and switches flush-to-zero and denormals-are-zero off for this thread, and
/// restores what the caller had on destruction. render() holds one, so a caller's FTZ does not change a byte.
class FloatingPointScope {
 public:
  FloatingPointScope();
  ~FloatingPointScope();
  FloatingPointScope(const FloatingPointScope&) = delete;
  FloatingPointScope& operator=(const FloatingPointScope&) = delete;

 private:
  unsigned long long saved_;
};

}  // namespace velum
