#include "visibility/fragment_lists.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace velum;

namespace {

using Counts = std::vector<std::vector<int>>;

/// Lists that counted so many fragments at each pixel of `wanted`, which lies at (3, 2) in its frame.
struct Counted {
  explicit Counted(const Counts& counts)
      : wanted{3, 2, static_cast<int>(counts[0].size()), static_cast<int>(counts.size())},
        front(wanted.width + 3, wanted.height + 2) {
    front.reversed_depth.fill(1.0f);
    front.primitive.fill(0);
    lists.begin_counting(front, {0, 0, front.width(), front.height()}, wanted);
    for (int y = 0; y < wanted.height; ++y) {
      for (int x = 0; x < wanted.width; ++x) {
        const int count = counts[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
        for (int i = 0; i < count; ++i) lists.add(x + 3, y + 2, 0.5f, static_cast<std::uint32_t>(i));
      }
    }
  }

  Rect wanted;
  VisibilityBuffer front;
  FragmentLists lists;
};

}  // namespace

TEST_CASE("lists are cut into parts of whole rows, and into pieces of rows that are too long") {
  Counted few({{1, 1, 1}, {2, 0, 0}, {0, 0, 0}, {4, 0, 2}, {1, 0, 0}});
  CHECK(few.lists.parts(100) == std::vector<Rect>{{3, 2, 3, 5}});
  CHECK(few.lists.parts(6) == std::vector<Rect>{{3, 2, 3, 3}, {3, 5, 3, 1}, {3, 6, 3, 1}});
  // 4, 0, 2 does not fit: it is cut, and what is larger than a part stands alone.
  CHECK(few.lists.parts(3) ==
        std::vector<Rect>{{3, 2, 3, 1}, {3, 3, 3, 2}, {3, 5, 1, 1}, {4, 5, 2, 1}, {3, 6, 3, 1}});
}

TEST_CASE("a list is sorted, each fragment once, without what is not behind the front") {
  VisibilityBuffer front(2, 1);
  front.reversed_depth.at(0, 0) = 0.5f;
  front.primitive.at(0, 0) = 7;  // and the background at (1, 0): nothing is behind it
  FragmentLists lists;
  const auto add_all = [&lists] {
    for (const int x : {0, 1}) {
      lists.add(x, 0, 0.5f, 9);
      lists.add(x, 0, 0.25f, 3);
      lists.add(x, 0, 0.5f, 7);
      lists.add(x, 0, 0.5f, 6);
      lists.add(x, 0, 0.75f, 1);
      lists.add(x, 0, 0.25f, 3);
      lists.add(x, 0, 0.0f, 8);
    }
  };
  const Rect rect{0, 0, 2, 1};
  lists.begin_counting(front, rect, rect);
  add_all();
  lists.begin_storing(rect);
  add_all();
  lists.sort();
  const std::span<const std::uint64_t> list = lists.at(0, 0);
  REQUIRE(list.size() == 4);
  CHECK(list[0] == nearness(0.5f, 9));
  CHECK(list[1] == nearness(0.25f, 3));
  CHECK(list[2] == nearness(0.0f, 8));
  CHECK(list[3] == 0);
  CHECK(lists.at(1, 0).empty());
  CHECK(primitive_of(list[0]) == 9);
  CHECK(reversed_depth_of(list[1]) == 0.25f);
}
