#include "base/elementary_kernels.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/elementary.hpp"
#include "random.hpp"

using namespace velum;

namespace {

constexpr std::size_t lanes = 8;

/// As many pairs as given, to whole vectors with pairs that take the common way, so that one special value
/// does not send its neighbours another.
struct Pairs {
  std::vector<double> x, y;
  void add(double base, double power) {
    x.push_back(base);
    y.push_back(power);
  }
  void add_alone(double base, double power) {
    for (std::size_t i = 0; i < lanes; ++i) add(base, power);
  }
};

void check_pow(Pairs pairs) {
  while (pairs.x.size() % lanes != 0) pairs.add(0.5, 3.0);
  std::vector<double> out(pairs.x.size());
  for (const Isa isa : available_isas()) {
    if (isa == Isa::reference) continue;
    CAPTURE(name_of(isa));
    pow_kernel(isa)(pairs.x.data(), pairs.y.data(), out.size(), out.data());
    std::size_t different = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double expected = elementary::pow(pairs.x[i], pairs.y[i]);
      const bool is_same = std::bit_cast<std::uint64_t>(expected) == std::bit_cast<std::uint64_t>(out[i]) ||
                           (expected != expected && out[i] != out[i]);
      if (is_same) continue;
      if (++different == 1) MESSAGE(pairs.x[i] << " to the power of " << pairs.y[i]);
    }
    CHECK(different == 0);
  }
}

/// What lighting asks for: cosines to the power of a shininess.
Pairs cosines(Random& random, int count) {
  Pairs pairs;
  for (int i = 0; i < count; ++i) {
    const double closeness = random.uniform(0.0, 50.0);
    const double cosine = i % 2 == 0 ? random.uniform() : 1.0 - elementary::exp(-closeness);
    pairs.add(cosine, i % 3 == 0 ? static_cast<double>(random.below(300)) : random.uniform(0.0, 1000.0));
  }
  return pairs;
}

Pairs any_bits(Random& random, int count) {
  Pairs pairs;
  for (int i = 0; i < count; ++i)
    pairs.add_alone(std::bit_cast<double>(random.next()), std::bit_cast<double>(random.next()));
  return pairs;
}

/// Where the result is near the ends of the range of doubles, normal and not.
Pairs extreme_results(Random& random, int count) {
  Pairs pairs;
  for (int i = 0; i < count; ++i) {
    const double x = elementary::exp(random.uniform(-700.0, 700.0));
    pairs.add(x, random.uniform(-760.0, 760.0) / elementary::log(x));
  }
  return pairs;
}

}  // namespace

TEST_CASE("pow by vectors gives the scalar one's bits") {
  Random random{5};
  check_pow(cosines(random, 20000));
  check_pow(extreme_results(random, 20000));
  check_pow(any_bits(random, 4000));
}

TEST_CASE("[long] pow by vectors: ten million pairs") {
  Random random{6};
  for (int round = 0; round < 50; ++round) {
    check_pow(cosines(random, 100000));
    check_pow(extreme_results(random, 100000));
    check_pow(any_bits(random, 2000));
  }
}

TEST_CASE("pow by vectors: special values, alone and among others") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double largest = std::numeric_limits<double>::max();
  constexpr double smallest = std::numeric_limits<double>::min();
  const std::vector<double> specials{
      0.0,     -0.0,    1.0,       -1.0,          2.0,           0.5,
      3.0,     -3.0,    infinity,  1e-5,          -0.5,          -infinity,
      largest, 0x1p64,  -0x1p64,   smallest,      0x1p-70,       1e19,
      1e18,    0x1p-71, 0x1p-1074, 1.0 - 0x1p-53, 1.0 + 0x1p-52, std::numeric_limits<double>::quiet_NaN()};
  Pairs alone, among;
  for (const double x : specials) {
    for (const double y : specials) {
      alone.add_alone(x, y);
      among.add(x, y);
    }
  }
  check_pow(alone);
  check_pow(among);
}
