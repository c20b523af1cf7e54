#include "image/image.hpp"

#include <doctest/doctest.h>

#include <glm/vec3.hpp>

#include "image/visibility_buffer.hpp"

using velum::Image;
using velum::ImageView;

TEST_CASE("rows are padded to whole multiples of 64 bytes") {
  CHECK(Image<float>(17, 3).stride() == 32);
  CHECK(Image<float>(16, 3).stride() == 16);
  CHECK(Image<std::uint8_t>(1, 1).stride() == 64);
  CHECK(Image<glm::vec3>(17, 2).stride() * static_cast<std::ptrdiff_t>(sizeof(glm::vec3)) % 64 == 0);
  CHECK(Image<float>().is_empty());
  CHECK(Image<float>(0, 5).is_empty());
  CHECK_THROWS_AS(Image<float>(-1, 5), velum::ContractViolation);
}

TEST_CASE("rows begin at cache lines, so that kernels can write whole ones") {
  for (int width = 1; width < 200; width += 13) {
    const Image<float> floats(width, 3);
    const Image<glm::vec3> vectors(width, 3);
    for (int y = 0; y < 3; ++y) {
      CHECK(reinterpret_cast<std::uintptr_t>(floats.row(y)) % 64 == 0);
      CHECK(reinterpret_cast<std::uintptr_t>(vectors.row(y)) % 64 == 0);
    }
  }
}

TEST_CASE("a view shares the pixels; a window of it keeps the stride") {
  Image<int> image(5, 4, 7);
  image.at(2, 1) = 9;
  const ImageView<int> window{image.row(1) + 2, 3, 2, image.stride()};
  CHECK(window.at(0, 0) == 9);
  window.at(2, 1) = 11;
  CHECK(image.at(4, 2) == 11);
  const ImageView<const int> read_only = window;
  CHECK(read_only.at(2, 1) == 11);
  CHECK(ImageView<int>{}.is_empty());
  image.resize(2, 2, 1);
  CHECK(image.at(1, 1) == 1);
}

TEST_CASE("a cleared visibility buffer shows the background; nearer means larger r, then smaller id") {
  const velum::VisibilityBuffer buffer(3, 2);
  CHECK(buffer.width() == 3);
  CHECK(buffer.height() == 2);
  CHECK(buffer.primitive.at(2, 1) == velum::no_primitive);
  CHECK(buffer.reversed_depth.at(2, 1) == 0.0f);
  CHECK(velum::is_nearer(0.5f, 9, 0.25f, 1));
  CHECK(velum::is_nearer(0.5f, 1, 0.5f, 2));
  CHECK_FALSE(velum::is_nearer(0.5f, 2, 0.5f, 2));
  CHECK(velum::is_nearer(0.0f, 3, 0.0f, velum::no_primitive));
}
