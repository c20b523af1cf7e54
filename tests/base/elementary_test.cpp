#include "base/elementary.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "random.hpp"

// The C library's long double functions are the oracle here; the library itself never calls them.
namespace {

namespace elementary = velum::elementary;
using Function = double (*)(double);
using Oracle = long double (*)(long double);

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double tiny = std::numeric_limits<double>::denorm_min();
constexpr double largest = std::numeric_limits<double>::max();

/// Distance of got from the exact value, in units in the last place of the latter.
double ulp_error(double got, long double exact) {
  const double rounded = static_cast<double>(exact);
  if (std::isnan(rounded)) return std::isnan(got) ? 0.0 : inf;
  if (std::isinf(rounded) || std::isinf(got)) return got == rounded ? 0.0 : inf;
  const int exponent = rounded == 0.0 ? -1074 : std::max(std::ilogb(rounded) - 52, -1074);
  return static_cast<double>(std::fabs(got - exact) / std::ldexp(1.0L, exponent));
}

struct Worst {
  double error = 0.0;
  double x = 0.0;
  double y = 0.0;
  void take(double new_error, double at_x, double at_y = 0.0) {
    if (new_error > error) *this = {new_error, at_x, at_y};
  }
};

void take(Worst& worst, Function function, Oracle oracle, double x) {
  for (const double signed_x : {x, -x}) worst.take(ulp_error(function(signed_x), oracle(signed_x)), signed_x);
}

Worst worst_over(Function function, Oracle oracle, double low, double high, int count = 20000) {
  Random random{20240607};
  Worst worst;
  for (int i = 0; i < count; ++i) take(worst, function, oracle, random.uniform(low, high));
  return worst;
}

/// Any exponent, so that the very small and the very large have their share.
Worst worst_over_exponents(Function function, Oracle oracle, int low, int high, int count = 20000) {
  Random random{7};
  Worst worst;
  for (int i = 0; i < count; ++i) {
    const int exponent = low + static_cast<int>(random.next() % static_cast<unsigned>(high - low + 1));
    take(worst, function, oracle, std::ldexp(random.uniform(1.0, 2.0), exponent));
  }
  return worst;
}

void check_bound(const Worst& worst, double bound) {
  CAPTURE(worst.x);
  CAPTURE(worst.y);
  CHECK(worst.error <= bound);
  CHECK(worst.error > 0.3);  // an exact result everywhere would mean that nothing was measured
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

TEST_CASE("sin, cos and tan keep their bounds for every size of the angle") {
  struct Case {
    Function function;
    Oracle oracle;
    double bound;
  };
  const Case cases[] = {
      {elementary::sin, std::sin, 1.0}, {elementary::cos, std::cos, 1.0}, {elementary::tan, std::tan, 2.5}};
  for (const Case& c : cases) {
    check_bound(worst_over(c.function, c.oracle, 0.0, 1.0), c.bound);
    check_bound(worst_over(c.function, c.oracle, 0.0, 10.0), c.bound);
    check_bound(worst_over(c.function, c.oracle, 0.0, 1e5), c.bound);
    check_bound(worst_over_exponents(c.function, c.oracle, -40, 1023), c.bound);
    Worst near_multiples;
    for (int k = 1; k < 5000; ++k) take(near_multiples, c.function, c.oracle, k * (velum::pi / 2));
    for (int k = 1; k < 5000; ++k)
      take(near_multiples, c.function, c.oracle, std::nextafter(k * (velum::pi / 4), 0.0));
    check_bound(near_multiples, c.bound);
    // The double nearest to a multiple of pi/2, relative to its size (Kahan; Muller et al. 2018, 11.2).
    take(near_multiples, c.function, c.oracle, 0x1.6ac5b262ca1ffp+849);
    check_bound(near_multiples, c.bound);
  }
}

TEST_CASE("asin, acos and atan keep their bounds") {
  check_bound(worst_over(elementary::asin, std::asin, 0.0, 1.0), 1.0);
  check_bound(worst_over_exponents(elementary::asin, std::asin, -40, -1), 1.0);
  check_bound(worst_over(elementary::acos, std::acos, 0.0, 1.0), 1.0);
  check_bound(worst_over(elementary::acos, std::acos, 0.999, 1.0), 1.0);
  check_bound(worst_over(elementary::atan, std::atan, 0.0, 4.0), 1.0);
  check_bound(worst_over_exponents(elementary::atan, std::atan, -30, 60), 1.0);
}

TEST_CASE("exp and log keep their bounds") {
  check_bound(worst_over(elementary::exp, std::exp, 0.0, 1.0), 1.0);
  check_bound(worst_over(elementary::exp, std::exp, 0.0, 709.0), 1.0);
  check_bound(worst_over(elementary::exp, std::exp, 708.0, 745.0), 1.0);
  check_bound(worst_over(elementary::log, std::log, 0.5, 2.0), 1.0);
  check_bound(worst_over(elementary::log, std::log, 0.99, 1.01), 1.0);
  check_bound(worst_over_exponents(elementary::log, std::log, -1074, 1023), 1.0);
}

TEST_CASE("atan2 keeps its bound") {
  Random random{3};
  Worst worst;
  for (int i = 0; i < 40000; ++i) {
    const double y = std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(random.next() % 40));
    const double x = std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(random.next() % 40));
    worst.take(ulp_error(elementary::atan2(y, x), std::atan2(static_cast<long double>(y), x)), y, x);
  }
  check_bound(worst, 2.0);
}

TEST_CASE("pow keeps its bound") {
  Random random{4};
  Worst worst;
  Worst overflow_side;
  for (int i = 0; i < 40000; ++i) {
    const double x = random.uniform(0.0, 3.0);
    const double y = random.uniform(-20.0, 20.0);
    worst.take(ulp_error(elementary::pow(x, y), std::pow(static_cast<long double>(x), y)), x, y);
    // Results all over the range, subnormal ones too.
    const double base = std::ldexp(random.uniform(1.0, 2.0), static_cast<int>(random.next() % 2000) - 1000);
    const double exponent = random.uniform(-745.0, 709.0) / std::log(base);
    overflow_side.take(
        ulp_error(elementary::pow(base, exponent), std::pow(static_cast<long double>(base), exponent)), base,
        exponent);
  }
  check_bound(worst, 1.0);
  check_bound(overflow_side, 1.0);
}

TEST_CASE("pow close to one with large exponents") {
  Random random{5};
  Worst worst;
  for (int i = 0; i < 10000; ++i) {
    const double x = 1.0 + random.uniform(-1e-8, 1e-8);
    const double y = random.uniform(-5e10, 5e10);
    worst.take(ulp_error(elementary::pow(x, y), std::exp(y * std::log1p(static_cast<long double>(x) - 1))), x,
               y);
  }
  check_bound(worst, 1.0);
}

TEST_CASE("special arguments of the trigonometric functions") {
  for (const Function f : {elementary::sin, elementary::cos, elementary::tan}) {
    CHECK(std::isnan(f(inf)));
    CHECK(std::isnan(f(-inf)));
    CHECK(std::isnan(f(not_a_number)));
  }
  for (const Function f : {elementary::sin, elementary::tan, elementary::asin, elementary::atan}) {
    CHECK(same_bits(f(0.0), 0.0));
    CHECK(same_bits(f(-0.0), -0.0));
    CHECK(f(tiny) == tiny);
    CHECK(f(-tiny) == -tiny);
  }
  CHECK(elementary::cos(0.0) == 1.0);
  CHECK(elementary::cos(tiny) == 1.0);
  CHECK(elementary::sin(velum::pi / 2) == 1.0);
  CHECK(elementary::cos(velum::pi) == -1.0);
  CHECK(elementary::tan(velum::pi / 4) == std::tan(velum::pi / 4));
  CHECK(elementary::asin(1.0) == velum::pi / 2);
  CHECK(elementary::asin(-1.0) == -velum::pi / 2);
  CHECK(same_bits(elementary::acos(1.0), 0.0));
  CHECK(elementary::acos(-1.0) == velum::pi);
  CHECK(elementary::acos(0.0) == velum::pi / 2);
  CHECK(elementary::acos(0.5) == std::acos(0.5));
  for (const double x : {1.0000000000000002, -1.0000000000000002, 2.0, inf, -inf, not_a_number}) {
    CHECK(std::isnan(elementary::asin(x)));
    CHECK(std::isnan(elementary::acos(x)));
  }
  CHECK(elementary::atan(inf) == velum::pi / 2);
  CHECK(elementary::atan(-inf) == -velum::pi / 2);
  CHECK(std::isnan(elementary::atan(not_a_number)));
}

TEST_CASE("atan2 agrees with Annex F at every pair of special arguments") {
  const double values[] = {0.0, -0.0, 1.0, -1.0, inf, -inf, tiny, -tiny, largest, -largest, not_a_number};
  for (const double y : values) {
    for (const double x : values) {
      CAPTURE(y);
      CAPTURE(x);
      const double expected = std::atan2(y, x);
      const double got = elementary::atan2(y, x);
      if (std::isnan(expected)) {
        CHECK(std::isnan(got));
      } else {
        CHECK(std::signbit(got) == std::signbit(expected));
        CHECK(ulp_error(got, std::atan2(static_cast<long double>(y), x)) <= 2.0);
      }
    }
  }
}

TEST_CASE("special arguments of exp and log") {
  CHECK(elementary::exp(0.0) == 1.0);
  CHECK(elementary::exp(-0.0) == 1.0);
  CHECK(elementary::exp(tiny) == 1.0);
  CHECK(elementary::exp(inf) == inf);
  CHECK(same_bits(elementary::exp(-inf), 0.0));
  CHECK(elementary::exp(709.8) == inf);
  CHECK(elementary::exp(1e300) == inf);
  CHECK(elementary::exp(-746.0) == 0.0);
  CHECK(elementary::exp(-745.13) == tiny);
  CHECK(elementary::exp(-1e300) == 0.0);
  CHECK(std::isnan(elementary::exp(not_a_number)));
  CHECK(same_bits(elementary::log(1.0), 0.0));
  CHECK(elementary::log(0.0) == -inf);
  CHECK(elementary::log(-0.0) == -inf);
  CHECK(elementary::log(inf) == inf);
  CHECK(std::isnan(elementary::log(-1.0)));
  CHECK(std::isnan(elementary::log(-inf)));
  CHECK(std::isnan(elementary::log(not_a_number)));
  CHECK(ulp_error(elementary::log(tiny), std::log(static_cast<long double>(tiny))) <= 1.0);
}

TEST_CASE("pow agrees with Annex F at every pair of special arguments") {
  const double values[] = {0.0,
                           -0.0,
                           1.0,
                           -1.0,
                           2.0,
                           -2.0,
                           3.0,
                           -3.0,
                           0.5,
                           -0.5,
                           2.5,
                           -2.5,
                           inf,
                           -inf,
                           tiny,
                           -tiny,
                           not_a_number,
                           1e300,
                           -1e300,
                           largest,
                           1e-300,
                           0x1p53,
                           0x1p53 - 1,
                           1.0000000000000002,
                           0.9999999999999999};
  for (const double x : values) {
    for (const double y : values) {
      CAPTURE(x);
      CAPTURE(y);
      const double expected = std::pow(x, y);
      const double got = elementary::pow(x, y);
      if (std::isnan(expected)) {
        CHECK(std::isnan(got));
      } else {
        CHECK(std::signbit(got) == std::signbit(expected));
        CHECK(ulp_error(got, std::pow(static_cast<long double>(x), y)) <= 1.0);
      }
    }
  }
}

TEST_CASE("floor and ceil are exact") {
  Random random{6};
  for (int i = 0; i < 20000; ++i) {
    const double x = std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(random.next() % 70) - 5);
    REQUIRE(same_bits(elementary::floor(x), std::floor(x)));
    REQUIRE(same_bits(elementary::ceil(x), std::ceil(x)));
  }
  for (const double x : {0.0, -0.0, 0.5, -0.5, 1.0, -1.0, tiny, -tiny, inf, -inf, 0x1p52, 0x1p63, -0x1p63,
                         largest, 0x1p52 - 0.5, -0x1p52 + 0.5}) {
    CAPTURE(x);
    CHECK(same_bits(elementary::floor(x), std::floor(x)));
    CHECK(same_bits(elementary::ceil(x), std::ceil(x)));
  }
  CHECK(std::isnan(elementary::floor(not_a_number)));
}
