#include "base/floating_point.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

#if defined(__x86_64__)
#include <xmmintrin.h>

namespace {

constexpr unsigned flush_to_zero = 0x8000u;
constexpr unsigned denormals_are_zero = 0x0040u;
constexpr unsigned round_up = 0x4000u;
constexpr unsigned modes = 0xe040u;

/// A caller with every mode that changes results; put back at the end, whatever happens.
struct UnusualCaller {
  unsigned saved = _mm_getcsr();
  UnusualCaller() { _mm_setcsr((saved & ~modes) | flush_to_zero | denormals_are_zero | round_up); }
  ~UnusualCaller() { _mm_setcsr(saved); }
};

struct Results {
  double denormal_product;
  double denormal_doubled;
  double third;
};

/// Volatile operands keep the arithmetic between the control words.
Results compute() {
  volatile double small = 0x1p-600;
  volatile double smaller = 0x1p-450;
  volatile double denormal = 0x1p-1060;
  volatile double one = 1.0;
  volatile double three = 3.0;
  volatile double product = small * smaller;
  volatile double doubled = denormal + denormal;
  volatile double third = one / three;
  return {product, doubled, third};
}

void check_usual(const Results& results) {
  CHECK(results.denormal_product == 0x1p-1050);
  CHECK(results.denormal_doubled == 0x1p-1059);
  CHECK(results.third == 0x1.5555555555555p-2);
}

}  // namespace

TEST_CASE("FloatingPointScope keeps denormals and rounds to nearest, and gives the caller's modes back") {
  check_usual(compute());
  Results before{};
  Results inside{};
  Results after{};
  unsigned word_before = 0;
  unsigned word_after = 0;
  {
    const UnusualCaller caller;
    before = compute();
    word_before = _mm_getcsr() & modes;
    {
      const velum::FloatingPointScope scope;
      inside = compute();
    }
    word_after = _mm_getcsr() & modes;
    after = compute();
  }
  check_usual(inside);
  CHECK(word_before == (flush_to_zero | denormals_are_zero | round_up));
  CHECK(word_after == word_before);
  for (const Results& results : {before, after}) {
    CHECK(results.denormal_product == 0.0);
    CHECK(results.denormal_doubled == 0.0);
    CHECK(results.third == 0x1.5555555555556p-2);
  }
}

TEST_CASE("FloatingPointScope gives the caller's modes back after an exception") {
  unsigned word_after = 0;
  {
    const UnusualCaller caller;
    try {
      const velum::FloatingPointScope scope;
      throw std::runtime_error("inside");
    } catch (const std::runtime_error&) {
      word_after = _mm_getcsr() & modes;
    }
  }
  CHECK(word_after == (flush_to_zero | denormals_are_zero | round_up));
}

#endif

TEST_CASE("FloatingPointScope nests") {
  const velum::FloatingPointScope outer;
  { const velum::FloatingPointScope inner; }
  volatile double denormal = 0x1p-1060;
  volatile double doubled = denormal + denormal;
  CHECK(doubled == 0x1p-1059);
}
