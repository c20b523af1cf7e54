// Colour from a larger picture: it is exactly that picture filtered, and all else is untouched.
#include <doctest/doctest.h>

#include <cstring>
#include <velum/velum.hpp>

#include "image/downsample.hpp"
#include "pipeline/memory_need.hpp"
#include "pipeline/supersample_stage.hpp"
#include "small_scenes.hpp"

using namespace velum;
using velum::test::camera_of;
using velum::test::meeting_solids;
using velum::test::moved;

namespace {

Scene solids_and_glass() {
  Scene scene = meeting_solids();
  Material glass;
  glass.alpha = 0.4f;
  scene.add(shapes::sphere(), moved({0.2, 0.5, 1.0}), scene.add_material(glass));
  Mesh line;
  line.positions = {glm::vec3(-1, -1, 1), glm::vec3(1, 1.1f, 0.5f)};
  line.segments = {glm::uvec2(0, 1)};
  line.points = {0};
  scene.add(line);
  return scene;
}

RenderSettings settings_of(int supersample, DownsampleFilter filter = DownsampleFilter::box) {
  RenderSettings settings;
  settings.width = 64;
  settings.height = 48;
  settings.supersample = supersample;
  settings.supersample_filter = filter;
  settings.threads = 1;
  return settings;
}

template <typename T>
bool same_rows(const Image<T>& a, const Image<T>& b) {
  if (a.width() != b.width() || a.height() != b.height()) return false;
  for (int y = 0; y < a.height(); ++y) {
    if (std::memcmp(a.row(y), b.row(y), sizeof(T) * static_cast<std::size_t>(a.width())) != 0) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("supersampling is the picture rendered larger, then filtered") {
  const Scene scene = solids_and_glass();
  for (const DownsampleFilter filter :
       {DownsampleFilter::box, DownsampleFilter::tent, DownsampleFilter::mitchell}) {
    for (const int times : {2, 3}) {
      const RenderSettings settings = settings_of(times, filter);
      const Camera camera = camera_of(scene, "perspective", settings);
      RenderSettings larger = settings;
      larger.supersample = 1;
      larger.width *= times;
      larger.height *= times;
      larger.line_width *= static_cast<float>(times);
      larger.point_size *= static_cast<float>(times);
      const Picture large = render(scene, camera, larger);
      Image<Rgba8> expected(64, 48);
      Downsampler downsampler(filter, times, 64, 48, {0, 0, 64, 48}, expected.view());
      for (int y = 0; y < larger.height; ++y) downsampler.add_row(large.colour.row(y));
      CHECK(same_rows(render(scene, camera, settings).colour, expected));
    }
  }
}

TEST_CASE("supersampling leaves depths, ids and normals alone, and their counters") {
  const Scene scene = solids_and_glass();
  RenderSettings settings = settings_of(1);
  const Camera camera = camera_of(scene, "perspective", settings);
  const Picture plain = render(scene, camera, settings);
  settings.supersample = 4;
  settings.samples = 4;
  const Picture fine = render(scene, camera, settings);
  CHECK(same_rows(fine.depth, plain.depth));
  CHECK(same_rows(fine.metric_depth, plain.metric_depth));
  CHECK(same_rows(fine.normal, plain.normal));
  CHECK(same_rows(fine.object_id, plain.object_id));
  CHECK(same_rows(fine.triangle_id, plain.triangle_id));
  CHECK_FALSE(same_rows(fine.colour, plain.colour));
  CHECK(fine.counters.triangles == plain.counters.triangles);
  CHECK(fine.counters.pixels_shaded > 10 * plain.counters.pixels_shaded);
}

TEST_CASE("supersampling: the same bytes with any method and number of threads, and in a crop") {
  const Scene scene = solids_and_glass();
  RenderSettings settings = settings_of(3, DownsampleFilter::mitchell);
  settings.wireframe = true;
  const Camera camera = camera_of(scene, "perspective", settings);
  const Picture whole = render(scene, camera, settings);
  settings.threads = 3;
  CHECK(same_rows(render(scene, camera, settings).colour, whole.colour));
  settings.visibility = VisibilityMethod::scanline;
  CHECK(same_rows(render(scene, camera, settings).colour, whole.colour));
  settings.crop = Rect{20, 0, 31, 40};
  const Picture part = render(scene, camera, settings);
  int different = 0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 31; ++x) different += !(part.colour.at(x, y) == whole.colour.at(x + 20, y));
  }
  CHECK(different == 0);
}

TEST_CASE("supersampling: bands ask for every row once, from the top") {
  RenderSettings settings = settings_of(8);
  settings.width = 4096;
  settings.height = 40;
  const Rect rect{100, 3, 2000, 37};
  Image<Rgba8> target(rect.width, rect.height), band;
  int next = 3 * 8, bands = 0;
  supersample(settings, rect, target.view(), band,
              [&](const Rect& part, const ImageView<Rgba8>& colour, double from, double to) {
                CHECK(part.top == next);
                CHECK((part.left == 800 && part.width == 16000));
                CHECK((colour.width == part.width && colour.height == part.height));
                CHECK(from < to);
                next = part.bottom();
                ++bands;
                for (int y = 0; y < colour.height; ++y)
                  colour.at(0, y) = {static_cast<std::uint8_t>(part.top + y), 0, 0, 255};
              });
  CHECK(next == 40 * 8);
  CHECK(bands == 2);
}

TEST_CASE("supersampling that cannot be is an error that says so") {
  const Scene scene = meeting_solids();
  const auto attempt = [&](RenderSettings settings) {
    render(scene, camera_of(scene, "perspective", settings), settings);
  };
  for (const int times : {0, -1, 9}) {
    CHECK_THROWS_WITH_AS(attempt(settings_of(times)), doctest::Contains("from 1 (none) to 8"), Error);
  }
  RenderSettings settings = settings_of(8);
  settings.width = 4097;
  settings.height = 16;
  CHECK_THROWS_WITH_AS(attempt(settings), doctest::Contains("more than 32768"), Error);
  settings = settings_of(8);
  settings.line_width = 40.0f;
  CHECK_THROWS_WITH_AS(attempt(settings), doctest::Contains("8 times as large"), Error);
}

TEST_CASE("supersampling counts as memory, but not all of the larger picture") {
  const Scene scene = meeting_solids();
  RenderSettings settings = settings_of(1);
  settings.width = 2000;
  settings.height = 2000;
  const Rect rect{0, 0, 2000, 2000};
  const std::uint64_t without = buffer_bytes(scene, settings, rect);
  settings.supersample = 8;
  const std::uint64_t with = buffer_bytes(scene, settings, rect);
  CHECK(with > without);
  CHECK(with < 16000u * 16000u);
}
