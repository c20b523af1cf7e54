#include <doctest/doctest.h>

#include <cstring>
#include <set>
#include <string>
#include <velum/velum.hpp>

using namespace velum;

namespace {

glm::dmat4 placed(const glm::dvec3& at, double size = 1.0) {
  glm::dmat4 m(size);
  m[3] = glm::dvec4(at, 1.0);
  return m;
}

/// Built-in solids that overlap in the picture, one of them mirrored, and two sheets in one place.
Scene solids() {
  Scene scene;
  scene.add(shapes::house());
  scene.add(shapes::torus(0.6f, 0.2f, 24, 12), placed({0.4, 0.6, 0.5}));
  glm::dmat4 mirrored = placed({-0.5, 0.5, 0.9}, 0.8);
  mirrored[0] = -mirrored[0];
  scene.add(shapes::letter_f(), mirrored);
  scene.add(shapes::icosphere(0.5f, 2), placed({0.9, 0.3, -0.2}));
  scene.add(shapes::grid(3.0f, 4), placed({0.0, 0.1, 0.0}));
  scene.add(shapes::grid(3.0f, 3), placed({0.0, 0.1, 0.0}));
  return scene;
}

RenderSettings settings_of(VisibilityMethod method, int width = 120, int height = 90) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.visibility = method;
  return settings;
}

template <typename T>
int different_rows(const Image<T>& a, const Image<T>& b) {
  REQUIRE(a.width() == b.width());
  REQUIRE(a.height() == b.height());
  int count = 0;
  for (int y = 0; y < a.height(); ++y) {
    count += std::memcmp(a.row(y), b.row(y), sizeof(T) * static_cast<std::size_t>(a.width())) != 0;
  }
  return count;
}

void check_same(const Picture& a, const Picture& b) {
  CHECK(different_rows(a.colour, b.colour) == 0);
  CHECK(different_rows(a.depth, b.depth) == 0);
  CHECK(different_rows(a.metric_depth, b.metric_depth) == 0);
  CHECK(different_rows(a.triangle_id, b.triangle_id) == 0);
  CHECK(a.counters.fragments == b.counters.fragments);
  CHECK(a.counters.fragments_written == b.counters.fragments_written);
  CHECK(a.counters.zero_area == b.counters.zero_area);
}

void check_methods(const Scene& scene, const Camera& camera, RenderSettings settings) {
  settings.visibility = VisibilityMethod::zbuffer;
  settings.isa = Isa::reference;
  const Picture expected = render(scene, camera, settings);
  settings.visibility = VisibilityMethod::scanline;
  const Picture actual = render(scene, camera, settings);
  check_same(expected, actual);
  CHECK(expected.coverage() > 0.0);
  CHECK(actual.counters.spans > 0);
}

Camera framed(const Scene& scene, const Projection& projection) {
  FrameOptions options;
  options.aspect = 120.0 / 90.0;
  return frame(scene.bounds(), projection, options);
}

template <typename T>
std::size_t distinct_values(const Image<T>& image) {
  std::set<T> values;
  for (int y = 0; y < image.height(); ++y) values.insert(image.row(y), image.row(y) + image.width());
  return values.size();
}

}  // namespace

TEST_CASE("scanline gives the z-buffer's picture of whole scenes under every projection, cropped too") {
  const Scene scene = solids();
  for (const ProjectionEntry& entry : projection_catalogue()) {
    CAPTURE(entry.name);
    const Camera camera = framed(scene, parse_projection(entry.name));
    RenderSettings settings = settings_of(VisibilityMethod::scanline);
    check_methods(scene, camera, settings);
    settings.crop = Rect{41, 37, 33, 17};
    check_methods(scene, camera, settings);
  }
}

TEST_CASE("scanline gives the z-buffer's picture for a viewer inside the scene") {
  const Scene scene = solids();
  for (const glm::dvec3& look : {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0.1, 0.3), glm::dvec3(0.2, -1, 0.1)}) {
    const Pose pose = {{0.05, 0.5, 0.1}, look, {0.1, 1.0, 0.2}};
    const Camera camera = Camera::perspective(pose, {VerticalAngle{radians(100.0)}}, 0.01, 20.0);
    check_methods(scene, camera, settings_of(VisibilityMethod::scanline));
  }
}

TEST_CASE("a scanline crop equals the same pixels of the whole, whatever the interpolation and the format") {
  const Scene scene = solids();
  const Camera camera = framed(scene, projection::perspective());
  const Rect crop{30, 20, 50, 40};
  for (const ZInterpolation mode :
       {ZInterpolation::plane, ZInterpolation::edges, ZInterpolation::incremental}) {
    RenderSettings settings = settings_of(VisibilityMethod::scanline);
    settings.z_interpolation = mode;
    settings.depth_format = DepthFormat::z24;
    const Picture whole = render(scene, camera, settings);
    settings.crop = crop;
    const Picture part = render(scene, camera, settings);
    int different = 0;
    for (int y = 0; y < crop.height; ++y) {
      for (int x = 0; x < crop.width; ++x) {
        different += part.triangle_id.at(x, y) != whole.triangle_id.at(x + crop.left, y + crop.top) ||
                     part.depth.at(x, y) != whole.depth.at(x + crop.left, y + crop.top);
      }
    }
    CHECK(different == 0);
  }
}

TEST_CASE("depth formats: both methods agree, and 8 bits leave at most 256 depths in the picture") {
  const Scene scene = solids();
  const Camera camera = framed(scene, projection::perspective());
  for (const DepthFormat format :
       {DepthFormat::float_z, DepthFormat::z24, DepthFormat::z16, DepthFormat::z8}) {
    RenderSettings settings = settings_of(VisibilityMethod::scanline);
    settings.depth_format = format;
    check_methods(scene, camera, settings);
    if (format == DepthFormat::z8) {
      CHECK(distinct_values(render(scene, camera, settings).depth) <= 256);
    }
  }
  CHECK(distinct_values(render(scene, camera, settings_of(VisibilityMethod::scanline)).depth) > 1000);
}

TEST_CASE("interpolated depths show the scene as the plane does, but for pixels where surfaces nearly meet") {
  const Scene scene = solids();
  const Camera camera = framed(scene, projection::perspective());
  RenderSettings settings = settings_of(VisibilityMethod::scanline);
  const Picture plane = render(scene, camera, settings);
  for (const ZInterpolation mode : {ZInterpolation::edges, ZInterpolation::incremental}) {
    settings.z_interpolation = mode;
    const Picture other = render(scene, camera, settings);
    int ids = 0;
    for (int y = 0; y < 90; ++y) {
      for (int x = 0; x < 120; ++x) ids += plane.triangle_id.at(x, y) != other.triangle_id.at(x, y);
    }
    CHECK(different_rows(plane.depth, other.depth) > 0);
    CHECK(ids < 1000);  // the two sheets in one place fight
  }
}

TEST_CASE("depth interpolation belongs to the scanline method: a usage error with the z-buffer") {
  const Scene scene = solids();
  RenderSettings settings = settings_of(VisibilityMethod::zbuffer);
  settings.z_interpolation = ZInterpolation::edges;
  try {
    render(scene, framed(scene, projection::perspective()), settings);
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::usage);
    CHECK(std::string(error.what()).find("scanline") != std::string::npos);
  }
}
