// The z-pyramid against brute force, and a bound that is not conservative against it.
#include "visibility/z_pyramid.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "random.hpp"

using namespace velum;

namespace {

/// A z-buffer with nearer and farther areas, ties and, at the right, background.
Image<float> random_depths(Random& random, int width, int height) {
  Image<float> image(width, height);
  const int cell = 1 + random.below(9);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      Random of_cell{static_cast<std::uint64_t>((y / cell) * 1000 + x / cell)};
      const double base = of_cell.uniform(0.2, 0.9);
      image.at(x, y) = x > width * 9 / 10 ? 0.0f : static_cast<float>(base + 0.1 * random.below(3));
    }
  }
  return image;
}

float farthest_of(const Image<float>& image, const Rect& rect) {
  float farthest = 2.0f;
  for (int y = rect.top; y < rect.bottom(); ++y) {
    for (int x = rect.left; x < rect.right(); ++x) farthest = std::min(farthest, image.at(x, y));
  }
  return farthest;
}

Rect random_rect(Random& random, int width, int height) {
  const int left = random.below(width), top = random.below(height);
  return {left, top, 1 + random.below(width - left), 1 + random.below(height - top)};
}

/// Every value of every level, from the pixels below it.
bool is_right(const ZPyramid& pyramid, const Image<float>& image) {
  for (int i = 1; i < pyramid.levels(); ++i) {
    const ImageView<const float> level = pyramid.level(i);
    const int side = 1 << i;
    if (level.width != (image.width() + side - 1) / side) return false;
    if (level.height != (image.height() + side - 1) / side) return false;
    for (int y = 0; y < level.height; ++y) {
      for (int x = 0; x < level.width; ++x) {
        const Rect cell = intersect({x * side, y * side, side, side}, {0, 0, image.width(), image.height()});
        if (level.at(x, y) != farthest_of(image, cell)) return false;
      }
    }
  }
  return pyramid.level(pyramid.levels() - 1).width == 1 && pyramid.level(pyramid.levels() - 1).height == 1;
}

}  // namespace

TEST_CASE("every level of the pyramid is the farthest of four, at any size") {
  Random random{1};
  ZPyramid pyramid;
  for (const auto& [width, height] :
       {std::pair{1, 1}, {2, 1}, {1, 7}, {3, 3}, {17, 5}, {64, 64}, {65, 33}, {100, 1}, {129, 127}}) {
    CAPTURE(width);
    CAPTURE(height);
    const Image<float> image = random_depths(random, width, height);
    pyramid.build(image);
    CHECK(is_right(pyramid, image));
  }
}

TEST_CASE("an update of what changed is a new pyramid") {
  Random random{2};
  for (int round = 0; round < 50; ++round) {
    const int width = 1 + random.below(90), height = 1 + random.below(90);
    Image<float> image(width, height, 0.0f);
    ZPyramid pyramid;
    pyramid.begin(image);
    CHECK(is_right(pyramid, image));
    for (int i = 0; i < 6; ++i) {
      const Rect rect = random_rect(random, width, height);
      for (int y = rect.top; y < rect.bottom(); ++y) {
        for (int x = rect.left; x < rect.right(); ++x) {
          image.at(x, y) = std::max(image.at(x, y), static_cast<float>(random.uniform()));
        }
      }
      pyramid.update(rect);
      CHECK(is_right(pyramid, image));
    }
  }
}

TEST_CASE("parts of a grid may be updated on their own up to the grid's level") {
  Random random{3};
  const Image<float> image = random_depths(random, 150, 90);
  ZPyramid pyramid;
  pyramid.begin(image);
  for (int y = 0; y < 90; y += 16) {
    for (int x = 0; x < 150; x += 16) pyramid.update(intersect({x, y, 16, 16}, {0, 0, 150, 90}), 1, 4);
  }
  pyramid.update({0, 0, 150, 90}, 5, pyramid.levels() - 1);
  CHECK(is_right(pyramid, image));
}

TEST_CASE("a rectangle is hidden exactly if all its pixels are strictly nearer") {
  Random random{4};
  int hidden = 0, decided_at[12] = {};
  for (int round = 0; round < 40; ++round) {
    const int width = 1 + random.below(150), height = 1 + random.below(150);
    const Image<float> image = random_depths(random, width, height);
    ZPyramid pyramid;
    pyramid.build(image);
    for (int i = 0; i < 500; ++i) {
      const Rect rect = random_rect(random, width, std::min(height, 1 + random.below(height)));
      const float farthest = farthest_of(image, rect);
      // Ties and values on both sides of the truth.
      const float bound = i % 3 == 0   ? farthest
                          : i % 3 == 1 ? std::nextafter(farthest, -1.0f)
                                       : static_cast<float>(random.uniform());
      const PyramidAnswer answer = pyramid.is_hidden(rect, bound);
      CHECK(answer.is_hidden == (bound < farthest));
      CHECK((answer.level >= 0 && answer.level < pyramid.levels()));
      hidden += answer.is_hidden;
      if (answer.is_hidden) ++decided_at[answer.level];
    }
  }
  CHECK(hidden > 1000);
  CHECK((decided_at[0] > 0 && decided_at[1] > 0 && decided_at[2] > 0));
}

TEST_CASE("a plane is hidden only if it is at every pixel, and more often than its nearest depth") {
  Random random{6};
  int hidden = 0, by_nearest = 0;
  for (int round = 0; round < 60; ++round) {
    const int width = 1 + random.below(100), height = 1 + random.below(100);
    const Image<float> image = random_depths(random, width, height);
    ZPyramid pyramid;
    pyramid.build(image);
    for (int i = 0; i < 100; ++i) {
      DepthPlane plane;
      plane.r_ref = static_cast<float>(random.uniform(0.0, 0.9));
      plane.dx = static_cast<float>(random.uniform(-0.01, 0.01));
      plane.dy = static_cast<float>(random.uniform(-0.01, 0.01));
      plane.x_ref = 50;
      plane.y_ref = 60;
      plane.upper = 1.0f;
      const Rect rect = random_rect(random, width, height);
      bool is_behind = true;
      float nearest = 0.0f;
      for (int y = rect.top; y < rect.bottom(); ++y) {
        for (int x = rect.left; x < rect.right(); ++x) {
          const float r = plane.at(x + 11, y + 22);
          is_behind = is_behind && r < image.at(x, y);
          nearest = std::max(nearest, r);
        }
      }
      const bool answer = pyramid.is_hidden(rect, plane, 11, 22).is_hidden;
      CHECK(answer == is_behind);
      hidden += answer;
      by_nearest += pyramid.is_hidden(rect, nearest).is_hidden;
    }
  }
  CHECK(hidden > by_nearest);
  CHECK(by_nearest > 100);
}

TEST_CASE("what reaches beyond the z-buffer is judged by what lies in it") {
  ZPyramid pyramid;
  const Image<float> image(10, 10, 0.5f);
  pyramid.build(image);
  CHECK(pyramid.is_hidden({-5, -5, 100, 100}, 0.4f).is_hidden);
  CHECK_FALSE(pyramid.is_hidden({-5, -5, 100, 100}, 0.5f).is_hidden);
  CHECK(pyramid.is_hidden({20, 20, 5, 5}, 1.0f).is_hidden);
  // The top level alone tells.
  CHECK(pyramid.is_hidden({2, 3, 4, 4}, 0.4f).level == pyramid.levels() - 1);
}

TEST_CASE("a bound that is not conservative is caught by brute force") {
  Random random{5};
  int wrong = 0;
  for (int round = 0; round < 200; ++round) {
    const Image<float> image = random_depths(random, 40, 40);
    ZPyramid pyramid;
    pyramid.build(image);
    const Rect rect = random_rect(random, 40, 40);
    // Something in the rectangle a hair nearer than the farthest pixel there: it is seen. A bound on its
    // depth that is rounded to the wrong side calls it hidden.
    const float depth = farthest_of(image, rect) * 1.005f;
    CHECK_FALSE(pyramid.is_hidden(rect, depth).is_hidden);
    wrong += pyramid.is_hidden(rect, depth / 1.01f).is_hidden;
  }
  CHECK(wrong > 50);
}
