#include "base/counters.hpp"

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cstddef>

using namespace velum;

TEST_CASE("Sums of counters leave none out; of layers and memory the most counts") {
  constexpr std::size_t count = sizeof(Counters) / sizeof(std::uint64_t);
  using Words = std::array<std::uint64_t, count>;
  Words a, b;
  for (std::size_t i = 0; i < count; ++i) {
    a[i] = i + 1;
    b[i] = 1000 + i;
  }
  Counters sum = std::bit_cast<Counters>(a);
  sum += std::bit_cast<Counters>(b);
  const Words words = std::bit_cast<Words>(sum);
  constexpr std::size_t layers = offsetof(Counters, layers) / sizeof(std::uint64_t);
  constexpr std::size_t octree_bytes =
      (offsetof(Counters, hierarchy) + offsetof(HierarchyCounters, octree_bytes)) / sizeof(std::uint64_t);
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_most = i == layers || i == octree_bytes;
    CHECK(words[i] == (is_most ? b[i] : a[i] + b[i]));
  }
}
