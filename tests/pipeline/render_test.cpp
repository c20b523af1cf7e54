#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <velum/velum.hpp>

#include "pipeline/stages.hpp"

using namespace velum;

namespace {

glm::dmat4 moved(const glm::dvec3& by) {
  glm::dmat4 m(1.0);
  m[3] = glm::dvec4(by, 1.0);
  return m;
}

Scene solids(const glm::dvec3& offset = glm::dvec3(0.0)) {
  Scene scene;
  scene.add(shapes::house(), moved(offset));
  scene.add(shapes::torus(0.5f, 0.2f, 20, 10), moved(offset + glm::dvec3(0.3, 0.2, 0.8)));
  return scene;
}

RenderSettings size(int width, int height) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  return settings;
}

Camera view_of(const Scene& scene, double aspect, const Projection& how = projection::perspective()) {
  FrameOptions options;
  options.aspect = aspect;
  return frame(scene.bounds(), how, options);
}

template <typename T>
bool same_bytes(const T* a, const T* b, int count) {
  return std::memcmp(a, b, sizeof(T) * static_cast<std::size_t>(count)) == 0;
}

/// Whether every pixel of `part` is the pixel of `whole` shifted by (left, top), in every output, to the bit.
bool equals_part(const Picture& part, const Picture& whole, int left, int top) {
  bool same = true;
  for (int y = 0; y < part.colour.height(); ++y) {
    const int width = part.colour.width();
    same = same && same_bytes(part.colour.row(y), whole.colour.row(y + top) + left, width) &&
           same_bytes(part.depth.row(y), whole.depth.row(y + top) + left, width) &&
           same_bytes(part.metric_depth.row(y), whole.metric_depth.row(y + top) + left, width) &&
           same_bytes(part.normal.row(y), whole.normal.row(y + top) + left, width) &&
           same_bytes(part.object_id.row(y), whole.object_id.row(y + top) + left, width) &&
           same_bytes(part.triangle_id.row(y), whole.triangle_id.row(y + top) + left, width);
  }
  return same;
}

ErrorKind kind_of_error(const Scene& scene, const Camera& camera, const RenderSettings& settings) {
  try {
    render(scene, camera, settings);
  } catch (const Error& error) {
    CHECK(std::string(error.what()).size() > 20);  // says what and what to do
    return error.kind();
  }
  FAIL("no error");
  return ErrorKind::usage;
}

}  // namespace

TEST_CASE("a crop equals the same pixels of the whole picture, in every output and shading") {
  const Scene scene = solids();
  const Camera camera = view_of(scene, 90.0 / 70.0);
  for (const Shading shading :
       {Shading::flat, Shading::gouraud, Shading::phong, Shading::depth, Shading::normal}) {
    RenderSettings settings = size(90, 70);
    settings.shading = shading;
    const Picture whole = render(scene, camera, settings);
    for (const Rect& crop :
         {Rect{0, 0, 90, 70}, Rect{31, 17, 40, 33}, Rect{89, 69, 1, 1}, Rect{0, 40, 90, 1}}) {
      settings.crop = crop;
      CHECK(equals_part(render(scene, camera, settings), whole, crop.left, crop.top));
    }
  }
}

TEST_CASE("moving scene and camera together 10,000 units away leaves the picture as it is") {
  // Offsets in binary fractions, so that the moved scene is the same scene.
  const glm::dvec3 offset(10000.0, 10000.0, 10000.0);
  for (const char* name : {"perspective", "cabinet", "isometric", "one-point"}) {
    const Scene here = solids();
    const Scene there = solids(offset);
    const Camera near_camera = view_of(here, 1.0, parse_projection(name));
    Pose pose = near_camera.pose();
    pose.position += offset;
    const Camera far_camera = near_camera.is_perspective()
                                  ? Camera::perspective(pose, std::get<PerspectiveLens>(near_camera.lens()),
                                                        near_camera.near(), near_camera.far())
                                  : Camera::parallel(pose, std::get<ParallelWindow>(near_camera.lens()),
                                                     near_camera.near(), near_camera.far());
    const Picture a = render(here, near_camera, size(128, 128));
    const Picture b = render(there, far_camera, size(128, 128));
    int different = 0;
    for (int y = 0; y < 128; ++y) {
      for (int x = 0; x < 128; ++x) different += a.triangle_id.at(x, y) != b.triangle_id.at(x, y);
    }
    CAPTURE(name);
    CHECK(different == 0);
  }
}

TEST_CASE("a Renderer used again, render_into and render give the same bytes") {
  const Scene scene = solids();
  const Camera camera = view_of(scene, 1.5);
  const Picture once = render(scene, camera, size(60, 40));
  Renderer renderer;
  renderer.render(scene, view_of(scene, 1.0), size(77, 77));
  CHECK(equals_part(renderer.render(scene, camera, size(60, 40)), once, 0, 0));

  std::vector<Rgba8> memory(100 * 40, Rgba8{1, 2, 3, 4});
  PictureTarget target;
  target.colour = {memory.data(), 60, 40, 100};
  const Counters counters = renderer.render_into(scene, camera, size(60, 40), target);
  CHECK(counters.pixels_shaded == once.counters.pixels_shaded);
  bool same = true, untouched = true;
  for (int y = 0; y < 40; ++y) {
    same = same && same_bytes(memory.data() + y * 100, once.colour.row(y), 60);
    for (int x = 60; x < 100; ++x)
      untouched = untouched && memory[static_cast<std::size_t>(y * 100 + x)] == Rgba8{1, 2, 3, 4};
  }
  CHECK(same);
  CHECK(untouched);
  target.colour.width = 59;
  CHECK_THROWS_AS(renderer.render_into(scene, camera, size(60, 40), target), Error);
}

TEST_CASE("background, depth and ids where nothing is seen") {
  Scene scene;
  const Picture picture = render(scene, Camera::perspective({}, {}, 1.0, 2.0), size(3, 2));
  CHECK(picture.colour.at(1, 1) == Rgba8{0, 0, 0, 0});
  CHECK(picture.depth.at(1, 1) == 1.0f);
  CHECK(picture.metric_depth.at(1, 1) == std::numeric_limits<float>::infinity());
  CHECK(picture.object_id.at(1, 1) == 0xFFFFFFFFu);
  CHECK(picture.triangle_id.at(1, 1) == 0xFFFFFFFFu);
  CHECK(picture.coverage() == 0.0);
  CHECK(picture.bounding_box().is_empty());
}

TEST_CASE("a fragment at z = 1 exactly is drawn") {
  Scene scene;
  Mesh sheet;
  sheet.positions = {glm::vec3(-9, -9, -2), glm::vec3(9, -9, -2), glm::vec3(0, 9, -2)};
  sheet.triangles = {glm::uvec3(0, 1, 2)};
  scene.add(sheet);
  const Picture picture = render(scene, Camera::parallel({}, {}, 1.0, 2.0), size(4, 4));
  CHECK(picture.triangle_id.at(2, 2) == 0);
  CHECK(picture.depth.at(2, 2) == 1.0f);
  CHECK(picture.metric_depth.at(2, 2) == doctest::Approx(2.0f));
}

TEST_CASE("NaN, infinite and degenerate triangles are skipped and counted; the rest is drawn") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  Scene scene;
  Mesh mesh;
  mesh.positions = {glm::vec3(-1, -1, -3), glm::vec3(1, -1, -3),       glm::vec3(0, 1, -3),
                    glm::vec3(nan, 0, -3), glm::vec3(0, infinity, -3), glm::vec3(3e38f, -3e38f, -3e38f)};
  mesh.triangles = {glm::uvec3(0, 1, 2), glm::uvec3(0, 1, 3), glm::uvec3(4, 1, 2),
                    glm::uvec3(0, 0, 0), glm::uvec3(0, 1, 1), glm::uvec3(0, 1, 5)};
  scene.add(mesh);
  const Picture picture = render(scene, Camera::perspective({}, {}, 1.0, 10.0), size(40, 40));
  CHECK(picture.counters.triangles == 6);
  CHECK(picture.counters.not_finite == 2);
  CHECK(picture.counters.edge_on >= 2);
  CHECK(picture.triangle_id.at(20, 20) == 0);
}

TEST_CASE("culling removes back faces: about half of a closed mesh, and nothing that is seen") {
  const Scene scene = solids();
  const Camera camera = view_of(scene, 1.0);
  RenderSettings settings = size(100, 100);
  const Picture all = render(scene, camera, settings);
  settings.cull = Cull::back;
  const Picture culled = render(scene, camera, settings);
  CHECK(culled.counters.culled == all.counters.back_facing);
  CHECK(culled.counters.culled_share() > 0.35);
  CHECK(culled.counters.culled_share() < 0.65);
  // The solids are closed: only pixels beside a silhouette, where snapping opens a sliver, may change.
  int different = 0;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) different += all.triangle_id.at(x, y) != culled.triangle_id.at(x, y);
  }
  CHECK(different <= 5);
  settings.cull = Cull::front;
  CHECK(render(scene, camera, settings).counters.culled + culled.counters.culled == all.counters.triangles);
}

TEST_CASE("a mirrored instance is seen from its front") {
  Scene scene;
  glm::dmat4 mirrored(1.0);
  mirrored[0].x = -1.0;
  scene.add(shapes::letter_f(), mirrored);
  RenderSettings settings = size(64, 64);
  settings.cull = Cull::back;
  const Camera camera = view_of(scene, 1.0, projection::front());
  const Picture picture = render(scene, camera, settings);
  settings.cull = Cull::none;
  CHECK(equals_part(picture, render(scene, camera, settings), 0, 0));
}

TEST_CASE("the widest picture allowed: 32768 x 16") {
  const Scene scene = solids();
  const Picture picture = render(scene, view_of(scene, 32768.0 / 16.0), size(32768, 16));
  CHECK(picture.coverage() > 0.0);
  CHECK(picture.bounding_box().height > 10);
}

TEST_CASE("a triangle with a corner in the centre of projection is dropped and counted") {
  AssembledTriangle triangle;
  triangle.vertices = {glm::dvec4(0, 0, 0.5, 1), glm::dvec4(0.5, 0, 0.5, 1), glm::dvec4(0.0)};
  Counters counters;
  std::vector<ScreenTriangle> pieces;
  set_up(triangle, 0, {64, 64}, counters, pieces);
  CHECK(pieces.empty());
  CHECK(counters.at_eye == 1);
  triangle.vertices[2] = {0, 0.5, 0.5, 1};
  set_up(triangle, 0, {64, 64}, counters, pieces);
  CHECK(pieces.size() == 1);
  CHECK(counters.at_eye == 1);
}

TEST_CASE("requests that cannot be met are errors before work begins") {
  const Scene scene = solids();
  const Camera camera = view_of(scene, 1.0);
  CHECK(kind_of_error(scene, camera, size(0, 10)) == ErrorKind::usage);
  CHECK(kind_of_error(scene, camera, size(10, 32769)) == ErrorKind::usage);
  const Camera square = Camera::perspective({}, {}, 1.0, 2.0, 1.0);
  CHECK(kind_of_error(scene, square, size(64, 32)) == ErrorKind::usage);  // it insists on aspect 1
  RenderSettings settings = size(64, 64);
  settings.crop = Rect{60, 0, 5, 5};
  CHECK(kind_of_error(scene, camera, settings) == ErrorKind::usage);
  settings = size(4096, 4096);
  settings.memory_ceiling = 1 << 20;
  CHECK(kind_of_error(scene, camera, settings) == ErrorKind::limit);
}

TEST_CASE("the memory ceiling counts padded rows, and what translucent pixels gather") {
  Scene scene = solids();
  const Camera camera = view_of(scene, 1.0 / 64);
  RenderSettings settings = size(1, 64);
  settings.isa = Isa::reference;  // no tiles
  const auto fits = [&](std::uint64_t bytes) {
    settings.memory_ceiling = bytes;
    try {
      render(scene, camera, settings);
      return true;
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::limit);
      return false;
    }
  };
  // A row of one pixel is padded to 64 bytes in each image, the normals' to 16 of their 12 bytes: six images
  // of the picture, two of the visibility buffer.
  constexpr std::uint64_t opaque = 64 * (7 * 64 + 16 * 12);
  CHECK(fits(opaque));
  CHECK_FALSE(fits(opaque - 1));
  settings.isa = Isa::best;
  std::uint64_t tiles = 64 * std::uint64_t{scene.primitive_count()};
  for (const Instance& instance : scene.instances()) {
    // A place and a depth for each vertex, and for each instance as much as 32 of them.
    tiles += 12 * (scene.meshes()[instance.mesh].positions.size() + 32);
  }
  CHECK(fits(opaque + tiles));
  CHECK_FALSE(fits(opaque + tiles - 1));
  settings.isa = Isa::reference;
  Material glass;
  glass.alpha = 0.5f;
  const std::uint32_t material = scene.add_material(glass);
  scene.add_instance({0, material, glm::dmat4(1.0), "glass"});
  // Colour, mark and count, padded; a list's end and an open pixel.
  constexpr std::uint64_t translucent = opaque + 64 * (3 * 64 + 4 + 4);
  CHECK(fits(translucent));
  CHECK_FALSE(fits(translucent - 1));
}

TEST_CASE("the progress callback sees growing shares and can cancel") {
  const Scene scene = solids();
  const Camera camera = view_of(scene, 1.0);
  RenderSettings settings = size(32, 32);
  double last = 0.0;
  settings.progress = [&](double share) {
    CHECK(share >= last);
    last = share;
    return true;
  };
  render(scene, camera, settings);
  CHECK(last == 1.0);
  settings.progress = [](double) { return false; };
  CHECK(kind_of_error(scene, camera, settings) == ErrorKind::cancelled);
}

TEST_CASE("custom shading is a callable over SurfacePoint") {
  const Scene scene = solids();
  RenderSettings settings = size(32, 32);
  settings.shader = [](const SurfacePoint& point) {
    return point.back_facing ? glm::vec4(1, 0, 0, 1) : glm::vec4(0, 1, 0, 1);
  };
  const Picture picture = render(scene, view_of(scene, 1.0), settings);
  CHECK(picture.colour.at(16, 20) == Rgba8{0, 255, 0, 255});
}

TEST_CASE(
    "metric depth is the distance along the look vector, for parallel, oblique and perspective cameras "
    "alike") {
  Scene scene;
  scene.add(shapes::grid(200.0f, 3));
  for (const char* name : {"perspective", "isometric", "cabinet:angle=30", "military", "two-point"}) {
    const Camera camera = view_of(scene, 1.0, parse_projection(name));
    RenderSettings settings = size(50, 50);
    glm::dvec3 look = camera.pose().look / glm::length(camera.pose().look);
    double worst = 0.0;
    settings.shader = [&](const SurfacePoint& point) {
      const double expected = glm::dot(point.position - camera.pose().position, look);
      worst = std::max(worst, std::fabs(point.metric_depth - expected) / expected);
      return point.colour;
    };
    const Picture picture = render(scene, camera, settings);
    CAPTURE(name);
    CHECK(worst < 1e-5);
  }
}

TEST_CASE("an embedder's matrix gives the same picture in every convention of depth") {
  const Scene scene = solids();
  const Camera camera = view_of(scene, 1.0);
  const glm::dmat4 m = camera.viewing_transform(1.0).clip_from_world();
  glm::dmat4 opengl = m, reversed = m, y_down = m;
  for (int i = 0; i < 4; ++i) {
    opengl[i][2] = 2.0 * m[i][2] - m[i][3];
    reversed[i][2] = m[i][3] - m[i][2];
    y_down[i][1] = -m[i][1];
  }
  const Picture own = render(scene, camera, size(64, 64));
  const Camera cameras[] = {Camera::from_clip_matrix(m, DepthRange::zero_to_one),
                            Camera::from_clip_matrix(opengl, DepthRange::minus_one_to_one),
                            Camera::from_clip_matrix(reversed, DepthRange::one_to_zero),
                            Camera::from_clip_matrix(y_down, DepthRange::zero_to_one, ClipY::down)};
  for (const Camera& embedded : cameras) {
    const Picture picture = render(scene, embedded, size(64, 64));
    int different = 0;
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) different += picture.triangle_id.at(x, y) != own.triangle_id.at(x, y);
    }
    CHECK(different == 0);
  }
}
