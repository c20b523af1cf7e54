#include "visibility/depth_format.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "projection/camera.hpp"
#include "random.hpp"
#include "visibility/depth_resolution.hpp"
#include "visibility/scanline.hpp"
#include "visibility/zbuffer.hpp"

using namespace velum;

namespace {

constexpr DepthFormat all_formats[] = {DepthFormat::reversed, DepthFormat::float_z, DepthFormat::z24,
                                       DepthFormat::z16, DepthFormat::z8};
constexpr DepthFormat quantised_formats[] = {DepthFormat::z24, DepthFormat::z16, DepthFormat::z8};

/// The stored depth of the value k of a quantised format.
float stored_of(DepthFormat format, std::uint32_t k) {
  return static_cast<float>(static_cast<double>(largest_value(format) - k) / largest_value(format));
}

void check_distinct(DepthFormat format, std::uint32_t step) {
  const std::uint32_t largest = largest_value(format);
  int wrong = 0;
  for (std::uint32_t k = 0; k + 1 <= largest; k += step) {
    const float nearer = stored_of(format, k), farther = stored_of(format, k + 1);
    wrong +=
        !(nearer > farther) || quantised_depth(format, nearer) != k || stored_depth(format, nearer) != nearer;
  }
  CHECK(wrong == 0);
}

Camera perspective(double near, double far) {
  return Camera::perspective({}, {}, near, far);
}
Camera parallel(double near, double far) {
  return Camera::parallel({}, {}, near, far);
}

long double distance_of(const Camera& camera, long double r) {
  const long double near = camera.near(), far = camera.far();
  if (!camera.is_perspective()) return far - r * (far - near);
  return near * far / (near + r * (far - near));
}

/// By brute force: the distance from the plane of `here`'s stored value to that of the next float that is
/// stored differently, walking away from the viewer, float by float.
double walked_step(const Camera& camera, DepthFormat format, float here) {
  const float stored = stored_depth(format, here);
  float r = here;
  while (stored_depth(format, r) == stored) r = std::nextafterf(r, 0.0f);
  return static_cast<double>(distance_of(camera, stored_depth(format, r)) - distance_of(camera, stored));
}

/// Two crossing sheets that differ by far less than 1/255 in depth.
std::array<ScreenTriangle, 2> crossing_sheets() {
  std::array<ScreenTriangle, 2> sheets;
  for (ScreenTriangle& sheet : sheets) {
    sheet.vertices = {SnappedVertex{0, 0}, SnappedVertex{64 * subpixels, 0},
                      SnappedVertex{0, 64 * subpixels}};
    sheet.depth.upper = 1.0f;
    sheet.depth.x_ref = 16;
  }
  sheets[0].depth.r_ref = sheets[1].depth.r_ref = 0.5f;
  sheets[0].depth.dx = 1e-5f;
  sheets[1].primitive = 1;
  return sheets;
}

int pixels_of(std::uint32_t id, const VisibilityBuffer& buffer) {
  int count = 0;
  for (int y = 0; y < buffer.height(); ++y) {
    for (int x = 0; x < buffer.width(); ++x) count += buffer.primitive.at(x, y) == id;
  }
  return count;
}

}  // namespace

TEST_CASE("quantised depths are the lecture's 0 ... 255, half up") {
  CHECK(quantised_depth(DepthFormat::z8, 1.0f) == 0);
  CHECK(quantised_depth(DepthFormat::z8, 0.0f) == 255);
  CHECK(quantised_depth(DepthFormat::z8, 0.5f) == 128);  // 127.5
  CHECK(quantised_depth(DepthFormat::z8, 0.25f) == 191);
  CHECK(quantised_depth(DepthFormat::z16, 0.5f) == 32768);
  CHECK(quantised_depth(DepthFormat::z24, 1.0f) == 0);
  CHECK(quantised_depth(DepthFormat::z24, 0.0f) == 16777215);
  CHECK(stored_depth(DepthFormat::z8, 0.5f) == static_cast<float>(127.0 / 255.0));
  CHECK(stored_depth(DepthFormat::reversed, 1e-30f) == 1e-30f);
  CHECK(stored_depth(DepthFormat::float_z, 1e-30f) == 0.0f);
  CHECK(stored_depth(DepthFormat::float_z, 0x1p-24f) == 0x1p-24f);
}

TEST_CASE("different values of a format are stored as different depths, and kept when stored again") {
  check_distinct(DepthFormat::z8, 1);
  check_distinct(DepthFormat::z16, 1);
  check_distinct(DepthFormat::z24, 251);
}

TEST_CASE("[long] all values of 24 bits are stored as different depths") {
  check_distinct(DepthFormat::z24, 1);
}

TEST_CASE("stored depths are monotone, in [0, 1], never -0, and as near as the format allows") {
  Random random{21};
  for (int i = 0; i < 20000; ++i) {
    const auto a = static_cast<float>(random.uniform()), b = static_cast<float>(random.uniform());
    for (const DepthFormat format : all_formats) {
      const float stored = stored_depth(format, a);
      CHECK((a <= b ? stored <= stored_depth(format, b) : stored >= stored_depth(format, b)));
      CHECK(stored >= 0.0f);
      CHECK(stored <= 1.0f);
      CHECK(!std::signbit(stored));
    }
    for (const DepthFormat format : quantised_formats) {
      CHECK(std::fabs(static_cast<double>(stored_depth(format, a)) - a) <=
            0.5 / largest_value(format) + 6e-8);
    }
    // Plain float32 z compares as its stored depth does.
    CHECK((1.0f - a < 1.0f - b) ==
          (stored_depth(DepthFormat::float_z, a) > stored_depth(DepthFormat::float_z, b)));
  }
}

TEST_CASE("with 8 bits close surfaces tie and the lower id takes the pixels: z-fighting") {
  const std::array<ScreenTriangle, 2> sheets = crossing_sheets();
  const auto seen_of_second = [&sheets](DepthFormat format) {
    VisibilityBuffer buffer(64, 64);
    rasterize_zbuffer(sheets, {buffer, {0, 0, 64, 64}, nullptr, format});
    return pixels_of(1, buffer);
  };
  const int expected = 16 * 63 - 15 * 16 / 2;  // left of the crossing at column 16
  CHECK(seen_of_second(DepthFormat::reversed) == expected);
  CHECK(seen_of_second(DepthFormat::float_z) == expected);
  CHECK(seen_of_second(DepthFormat::z24) == expected);
  CHECK(seen_of_second(DepthFormat::z16) < expected);
  CHECK(seen_of_second(DepthFormat::z8) < expected);
}

TEST_CASE("resolution over distance equals a float-by-float search") {
  for (const Camera& camera : {perspective(0.5, 50.0), parallel(0.5, 50.0), parallel(-3.0, 10.0)}) {
    for (const DepthFormat format : all_formats) {
      for (const float r : {0.999f, 0.75f, 0.3f, 0.1f, 0.05f}) {
        const auto distance = static_cast<double>(distance_of(camera, r));
        const double expected = walked_step(camera, format, r);
        CAPTURE(r);
        CHECK(depth_resolution_at(camera, format, distance) == doctest::Approx(expected).epsilon(1e-3));
      }
    }
  }
}

TEST_CASE("resolution in closed form: parallel, at the far end, and the loss of plain float32 z") {
  const Camera box = parallel(2.0, 12.0);
  CHECK(depth_resolution_at(box, DepthFormat::z8, 7.0) == doctest::Approx(10.0 / 255).epsilon(1e-5));
  CHECK(depth_resolution_at(box, DepthFormat::z16, 12.0) == doctest::Approx(10.0 / 65535).epsilon(1e-5));
  CHECK(depth_resolution_at(box, DepthFormat::float_z, 12.0) == doctest::Approx(10.0 * 0x1p-24));
  CHECK(depth_resolution_at(box, DepthFormat::z8, 99.0) == depth_resolution_at(box, DepthFormat::z8, 12.0));

  const Camera room = perspective(0.01, 1000.0);
  CHECK(depth_resolution_at(room, DepthFormat::float_z, 500.0) == doctest::Approx(1.5).epsilon(0.01));
  CHECK(depth_resolution_at(room, DepthFormat::reversed, 500.0) < 1e-4);
  CHECK(depth_resolution_at(room, DepthFormat::z8, 1000.0) > 990.0);
}

TEST_CASE("a far plane at infinity has steps without end there, and finite ones before it") {
  // Reversed z with an infinite far plane: x' = x, y' = y, z' = near, w' = -z.
  glm::dmat4 m(0.0);
  m[0][0] = m[1][1] = 1.0;
  m[3][2] = 0.5;
  m[2][3] = -1.0;
  const Camera camera = Camera::from_clip_matrix(m, DepthRange::one_to_zero);
  REQUIRE(std::isinf(camera.far()));
  CHECK(std::isinf(depth_resolution_at(camera, DepthFormat::z16, std::numeric_limits<double>::infinity())));
  // r = near / distance = 6425 / 65535 is a value of the format; so is 6424 / 65535.
  CHECK(depth_resolution_at(camera, DepthFormat::z16, 5.1) ==
        doctest::Approx(0.5 * 65535 / 6424 - 0.5 * 65535 / 6425));
}
