#include "image/downsample.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/common.hpp>
#include <vector>

#include "random.hpp"

using namespace velum;

namespace {

constexpr DownsampleFilter filters[] = {DownsampleFilter::box, DownsampleFilter::tent,
                                        DownsampleFilter::mitchell};

Image<Rgba8> random_picture(std::uint64_t seed, int width, int height) {
  Random random{seed};
  Image<Rgba8> picture(width, height);
  const auto byte = [&] { return static_cast<std::uint8_t>(random.below(256)); };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) picture.at(x, y) = {byte(), byte(), byte(), byte()};
  }
  return picture;
}

/// A part of the smaller picture.
Image<Rgba8> downsampled(const Image<Rgba8>& large, DownsampleFilter filter, int scale, const Rect& part) {
  Image<Rgba8> small(part.width, part.height, {1, 2, 3, 4});
  Downsampler downsampler(filter, scale, large.width() / scale, large.height() / scale, part, small.view());
  const Rect& source = downsampler.source();
  for (int y = source.top; y < source.bottom(); ++y) downsampler.add_row(large.row(y) + source.left);
  return small;
}

Image<Rgba8> downsampled(const Image<Rgba8>& large, DownsampleFilter filter, int scale) {
  return downsampled(large, filter, scale, {0, 0, large.width() / scale, large.height() / scale});
}

/// The same in double and in two dimensions at once.
glm::dvec4 expected_at(const Image<Rgba8>& large, DownsampleFilter filter, int scale, int x, int y) {
  glm::dvec4 sum(0.0);
  double weights = 0.0;
  for (int j = 0; j < large.height(); ++j) {
    for (int i = 0; i < large.width(); ++i) {
      const double weight = filter_value(filter, (i + 0.5) / scale - (x + 0.5)) *
                            filter_value(filter, (j + 0.5) / scale - (y + 0.5));
      const glm::dvec4 colour(linear_from_srgb(large.at(i, j)));
      sum += weight * glm::dvec4(glm::dvec3(colour) * colour.w, colour.w);
      weights += weight;
    }
  }
  return sum / weights;
}

}  // namespace

TEST_CASE("filters: the values of box, tent, and Mitchell and Netravali's with B = C = 1/3") {
  CHECK(filter_value(DownsampleFilter::box, 0.49) == 1.0);
  CHECK(filter_value(DownsampleFilter::box, -0.51) == 0.0);
  CHECK(filter_value(DownsampleFilter::tent, -0.25) == 0.75);
  CHECK(filter_value(DownsampleFilter::tent, 1.0) == 0.0);
  CHECK(filter_value(DownsampleFilter::mitchell, 0.0) == doctest::Approx(8.0 / 9.0));
  CHECK(filter_value(DownsampleFilter::mitchell, 1.0) == doctest::Approx(1.0 / 18.0));
  CHECK(filter_value(DownsampleFilter::mitchell, -1.0) == doctest::Approx(1.0 / 18.0));
  CHECK(filter_value(DownsampleFilter::mitchell, 1.5) < -0.03);  // the lobe that sharpens
  CHECK(filter_value(DownsampleFilter::mitchell, 2.0) == 0.0);
  // Each sums to 1 over any set of places one apart: a constant stays a constant.
  for (const DownsampleFilter filter : filters) {
    for (double x = -0.4999; x < 0.5; x += 0.01) {
      double sum = 0.0;
      for (int i = -3; i <= 3; ++i) sum += filter_value(filter, x + i);
      CHECK(sum == doctest::Approx(1.0).epsilon(1e-12));
    }
  }
}

TEST_CASE("filters: the weights sum to 1, at borders too, lie around the pixel and mirror") {
  for (const DownsampleFilter filter : filters) {
    for (int scale = 1; scale <= 8; ++scale) {
      for (const int size : {1, 2, 9}) {
        for (int pixel = 0; pixel < size; ++pixel) {
          const FilterTaps taps = taps_of(filter, scale, pixel, size);
          const FilterTaps mirrored = taps_of(filter, scale, size - 1 - pixel, size);
          double sum = 0.0;
          for (const float weight : taps.weights) sum += static_cast<double>(weight);
          CHECK(sum == doctest::Approx(1.0).epsilon(1e-6));
          CHECK(taps.first >= 0);
          CHECK(taps.end() <= size * scale);
          CHECK(static_cast<double>(taps.weights.size()) <= 2.0 * radius_of(filter) * scale + 1.0);
          REQUIRE(taps.weights.size() == mirrored.weights.size());
          for (std::size_t i = 0; i < taps.weights.size(); ++i)
            CHECK(taps.weights[i] ==
                  doctest::Approx(mirrored.weights[taps.weights.size() - 1 - i]).epsilon(1e-5));
        }
      }
    }
  }
}

TEST_CASE("filters: a constant stays a constant, to the code") {
  for (const DownsampleFilter filter : filters) {
    for (const int scale : {2, 3, 8}) {
      for (int code = 0; code < 256; code += 5) {
        const auto c = static_cast<std::uint8_t>(code);
        const Rgba8 colour{c, static_cast<std::uint8_t>(255 - c), 90, 255};
        const Image<Rgba8> small = downsampled(Image<Rgba8>(5 * scale, 4 * scale, colour), filter, scale);
        int different = 0;
        for (int y = 0; y < 4; ++y) {
          for (int x = 0; x < 5; ++x) different += !(small.at(x, y) == colour);
        }
        CHECK(different == 0);
      }
    }
  }
}

TEST_CASE("filters: rows and columns give what the sum over both gives, in linear light, premultiplied") {
  for (const DownsampleFilter filter : filters) {
    for (const int scale : {2, 3}) {
      const Image<Rgba8> large = random_picture(7, 9 * scale, 8 * scale);
      const Image<Rgba8> small = downsampled(large, filter, scale);
      int apart = 0;
      for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 9; ++x) {
          const glm::dvec4 sum = expected_at(large, filter, scale, x, y);
          const glm::dvec3 straight = glm::clamp(glm::dvec3(sum) / sum.w, 0.0, 1.0);
          const Rgba8 expected = srgb_from_linear(glm::vec4(straight, sum.w));
          const Rgba8 actual = small.at(x, y);
          apart += std::abs(actual.r - expected.r) > 1 || std::abs(actual.g - expected.g) > 1 ||
                   std::abs(actual.b - expected.b) > 1 || std::abs(actual.a - expected.a) > 1;
        }
      }
      CHECK(apart == 0);
    }
  }
}

TEST_CASE("filters: half white and half black is linear one half; box and Mitchell tell an edge apart") {
  Image<Rgba8> large(16, 4, {0, 0, 0, 255});
  for (int y = 0; y < 4; ++y) {
    for (int x = 7; x < 16; ++x) large.at(x, y) = {255, 255, 255, 255};
  }
  const Image<Rgba8> box = downsampled(large, DownsampleFilter::box, 2);
  CHECK(box.at(2, 0) == Rgba8{0, 0, 0, 255});
  CHECK(box.at(3, 0) == Rgba8{188, 188, 188, 255});
  CHECK(box.at(4, 0) == Rgba8{255, 255, 255, 255});
  for (int y = 0; y < 4; ++y) large.at(7, y) = {0, 0, 0, 255};  // now between two pixels
  const Image<Rgba8> tent = downsampled(large, DownsampleFilter::tent, 2);
  CHECK(tent.at(2, 0).r == 0);
  CHECK(tent.at(3, 0) == srgb_from_linear(glm::vec4(glm::vec3(0.125f), 1.0f)));
  CHECK(tent.at(4, 0) == srgb_from_linear(glm::vec4(glm::vec3(0.875f), 1.0f)));
  const Image<Rgba8> mitchell = downsampled(large, DownsampleFilter::mitchell, 2);
  CHECK(mitchell.at(1, 0) == Rgba8{0, 0, 0, 255});  // overshoots, and is clamped
  CHECK(mitchell.at(6, 0) == Rgba8{255, 255, 255, 255});
}

TEST_CASE("filters: what is transparent gives no colour") {
  Image<Rgba8> large(4, 4, {255, 0, 0, 0});
  large.at(0, 0) = large.at(0, 1) = {0, 255, 0, 255};
  CHECK(downsampled(large, DownsampleFilter::box, 2).at(0, 0) == Rgba8{0, 255, 0, 128});
  CHECK(downsampled(large, DownsampleFilter::box, 2).at(1, 1).a == 0);
}

TEST_CASE("filters: a part equals the same pixels of the whole") {
  const Image<Rgba8> large = random_picture(8, 36, 30);
  for (const DownsampleFilter filter : filters) {
    const Image<Rgba8> whole = downsampled(large, filter, 3);
    for (const Rect& part : {Rect{0, 0, 1, 1}, Rect{5, 4, 3, 2}, Rect{11, 0, 1, 10}, Rect{2, 9, 10, 1}}) {
      const Image<Rgba8> some = downsampled(large, filter, 3, part);
      for (int y = 0; y < part.height; ++y) {
        for (int x = 0; x < part.width; ++x) CHECK(some.at(x, y) == whole.at(part.left + x, part.top + y));
      }
    }
  }
}
