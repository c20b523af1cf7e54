#include "visibility/near_first.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "random.hpp"

using namespace velum;

namespace {

struct Item {
  int number;
  float nearest;
};

/// All items, bucket after bucket.
std::vector<Item> all_of(const NearFirst<Item>& sorted) {
  std::vector<Item> all;
  for (int k = 0; k < sorted.buckets(); ++k) {
    const auto bucket = sorted.bucket(k);
    all.insert(all.end(), bucket.begin(), bucket.end());
  }
  return all;
}

}  // namespace

TEST_CASE("Buckets go from near to far and lose nothing") {
  Random random{61};
  NearFirst<Item> sorted;
  for (const int count : {1, 2, 40, 500, 3}) {
    CAPTURE(count);
    sorted.begin(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) sorted.add({i, static_cast<float>(random.uniform())});
    sorted.sort(10);
    CHECK(sorted.buckets() == std::clamp(count / 10, 1, 8));
    std::vector<bool> is_there(static_cast<std::size_t>(count));
    for (const Item& item : all_of(sorted)) is_there[static_cast<std::size_t>(item.number)] = true;
    CHECK(all_of(sorted).size() == is_there.size());
    CHECK(std::find(is_there.begin(), is_there.end(), false) == is_there.end());
    float before = 1.0f;
    for (int k = 0; k < sorted.buckets(); ++k) {
      float farthest = before;
      for (const Item& item : sorted.bucket(k)) {
        CHECK(item.nearest <= before);
        farthest = std::min(farthest, item.nearest);
      }
      before = farthest;
    }
  }
}

TEST_CASE("Items of one depth stay in their order; none at all are none") {
  NearFirst<Item> sorted;
  sorted.begin(100);
  for (int i = 0; i < 100; ++i) sorted.add({i, 0.5f});
  sorted.sort(10);
  const std::vector<Item> all = all_of(sorted);
  REQUIRE(all.size() == 100);
  for (int i = 0; i < 100; ++i) CHECK(all[static_cast<std::size_t>(i)].number == i);
  sorted.begin(0);
  sorted.sort(10);
  CHECK(all_of(sorted).empty());
}
