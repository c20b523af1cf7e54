#include <doctest/doctest.h>

#include <cstring>

#include "pipeline/check_request.hpp"
#include "small_scenes.hpp"
#include "visibility/zbuffer.hpp"

using namespace velum;
using namespace velum::test;

namespace {

/// The visibility buffer that the z-buffer gives for the whole picture.
VisibilityBuffer rendered(const Scene& scene, const Camera& camera, const RenderSettings& settings) {
  const ViewingTransform viewing = requested_view(camera, settings);
  VisibilityBuffer buffer(settings.width, settings.height);
  std::vector<ScreenTriangle> pieces;
  Counters counters;
  for (std::uint32_t i = 0; i < scene.instances().size(); ++i) {
    const Instance& instance = scene.instances()[i];
    const Mesh& mesh = scene.meshes()[instance.mesh];
    ClipVertices vertices;
    transform_vertices(mesh.positions.span(), viewing.clip_from_object(instance.world_from_object), vertices);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const AssembledTriangle triangle =
          assemble(vertices, mesh.triangles[t], is_mirroring(instance.world_from_object), settings.cull,
                   clip_volume_of(settings), counters);
      if (triangle.fate == TriangleFate::accepted || triangle.fate == TriangleFate::to_clip) {
        set_up(triangle, scene.first_primitive(i) + t, {settings.width, settings.height}, counters, pieces);
      }
    }
  }
  rasterize_zbuffer(pieces, {buffer, {0, 0, settings.width, settings.height}});
  return buffer;
}

/// Pixels whose explanation names another id or other depth bits than the pictures.
int disagreements(const Scene& scene, const Camera& camera, const RenderSettings& settings) {
  const VisibilityBuffer buffer = rendered(scene, camera, settings);
  const Picture picture = render(scene, camera, settings);
  int count = 0;
  for (int y = 0; y < settings.height; ++y) {
    for (int x = 0; x < settings.width; ++x) {
      const PixelExplanation pixel = explain_pixel(scene, camera, settings, x, y);
      const bool seen = !pixel.fragments.empty();
      const std::uint32_t id = seen ? pixel.fragments[0].primitive : no_primitive;
      const float r = seen ? pixel.fragments[0].reversed_depth : 0.0f;
      const float depth = seen ? pixel.fragments[0].depth() : 1.0f;
      count += id != buffer.primitive.at(x, y) || id != picture.triangle_id.at(x, y) ||
               std::memcmp(&r, &buffer.reversed_depth.at(x, y), sizeof r) != 0 ||
               std::memcmp(&depth, &picture.depth.at(x, y), sizeof depth) != 0;
    }
  }
  return count;
}

std::string example_of(const ProjectionEntry& entry) {
  return entry.name == "axonometry" ? "axonometry:x=-7,y=90,z=222,sx=1,sy=1,sz=0.5" : std::string(entry.name);
}

bool is_consistent(const EdgeAtCentre& edge, const SnappedVertex& centre) {
  const std::int64_t dx = edge.to.x - edge.from.x, dy = edge.to.y - edge.from.y;
  const std::int64_t cross = dx * (centre.y - edge.from.y) - dy * (centre.x - edge.from.x);
  const bool owns = dy < 0 || (dy == 0 && dx > 0);
  return edge.cross == cross && edge.value == cross - (owns ? 0 : 1) && edge.value >= 0 &&
         edge.owns_its_points() == owns;
}

Mesh sheet(float z, float size = 9.0f) {
  Mesh mesh;
  mesh.positions = {glm::vec3(-size, -size, z), glm::vec3(size, -size, z), glm::vec3(0, size, z)};
  mesh.triangles = {glm::uvec3(0, 1, 2)};
  return mesh;
}

Camera front_camera() {
  ParallelWindow window;
  window.height = 2.0;
  return Camera::parallel(Pose::towards({0, 0, 5}, {0, 0, 0}), window, 1.0, 9.0, 1.0);
}

}  // namespace

TEST_CASE("the winner is what the picture shows, id and depth bits, at every pixel under every projection") {
  const Scene solids = meeting_solids();
  const Scene random = random_triangles(31, 40);
  const RenderSettings settings = size(16, 11);
  for (const ProjectionEntry& entry : projection_catalogue()) {
    CAPTURE(entry.name);
    CHECK(disagreements(solids, camera_of(solids, example_of(entry), settings), settings) == 0);
    CHECK(disagreements(random, camera_of(random, example_of(entry), settings), settings) == 0);
  }
  const Camera inside = camera_of(random, "perspective", settings, glm::dvec3(0.2, 0.1, 0.3));
  CHECK(disagreements(random, inside, settings) == 0);
}

TEST_CASE("the winner is what the picture shows with culling, too") {
  const Scene solids = meeting_solids();
  RenderSettings settings = size(16, 11);
  for (const Cull cull : {Cull::back, Cull::front}) {
    settings.cull = cull;
    CHECK(disagreements(solids, camera_of(solids, "cabinet", settings), settings) == 0);
  }
}

TEST_CASE("the winner is what the picture shows with every depth format and interpolation") {
  const Scene solids = meeting_solids();
  RenderSettings settings = size(16, 11);
  const Camera camera = camera_of(solids, "perspective", settings);
  settings.visibility = VisibilityMethod::scanline;
  for (const DepthFormat format : {DepthFormat::float_z, DepthFormat::z16, DepthFormat::z8}) {
    for (const ZInterpolation mode :
         {ZInterpolation::plane, ZInterpolation::edges, ZInterpolation::incremental}) {
      settings.depth_format = format;
      settings.z_interpolation = mode;
      const Picture picture = render(solids, camera, settings);
      for (int y = 0; y < settings.height; ++y) {
        for (int x = 0; x < settings.width; ++x) {
          const PixelExplanation pixel = explain_pixel(solids, camera, settings, x, y);
          if (pixel.fragments.empty()) continue;
          CHECK(pixel.fragments[0].primitive == picture.triangle_id.at(x, y));
          CHECK(pixel.fragments[0].depth() == picture.depth.at(x, y));
        }
      }
    }
  }
}

TEST_CASE("fragments come in the order in which peeling shows them, each with three edges it is inside of") {
  const Scene scene = random_triangles(32, 60);
  const RenderSettings settings = size(12, 12);
  const Camera camera = camera_of(scene, "isometric", settings);
  int deepest = 0;
  bool consistent = true;
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 12; ++x) {
      const PixelExplanation pixel = explain_pixel(scene, camera, settings, x, y);
      deepest = std::max(deepest, static_cast<int>(pixel.fragments.size()));
      for (std::size_t i = 0; i < pixel.fragments.size(); ++i) {
        const CoveringFragment& fragment = pixel.fragments[i];
        for (const EdgeAtCentre& edge : fragment.edges)
          consistent = consistent && is_consistent(edge, pixel.centre);
        if (i == 0) continue;
        const CoveringFragment& front = pixel.fragments[i - 1];
        consistent = consistent && is_nearer(front.reversed_depth, front.primitive, fragment.reversed_depth,
                                             fragment.primitive);
      }
    }
  }
  CHECK(consistent);
  CHECK(deepest >= 5);
}

TEST_CASE("who wins and why: nearer, tie, farther") {
  Scene scene;
  scene.add(sheet(0.0f));
  scene.add(sheet(1.0f));
  scene.add(sheet(1.0f));
  const PixelExplanation pixel = explain_pixel(scene, front_camera(), size(8, 8), 4, 4);
  REQUIRE(pixel.fragments.size() == 3);
  CHECK(pixel.fragments[0].primitive == 1);
  CHECK(pixel.fragments[0].outcome == FragmentOutcome::seen);
  CHECK(pixel.fragments[0].reversed_depth == 0.625f);  // 4 of 1…9: z = 3/8
  CHECK(pixel.fragments[1].primitive == 2);
  CHECK(pixel.fragments[1].outcome == FragmentOutcome::higher_id);
  CHECK(pixel.fragments[2].primitive == 0);
  CHECK(pixel.fragments[2].outcome == FragmentOutcome::farther);
  CHECK(pixel.centre == SnappedVertex{1152, 1152});
  REQUIRE(pixel.winner.has_value());
  CHECK(pixel.winner->primitive == 1);
}

TEST_CASE("the background has no winner; a pixel outside is an error that names the range") {
  Scene scene;
  scene.add(sheet(0.0f, 0.1f));
  const PixelExplanation pixel = explain_pixel(scene, front_camera(), size(8, 8), 0, 0);
  CHECK(pixel.fragments.empty());
  CHECK_FALSE(pixel.winner.has_value());
  CHECK(pixel.counters.triangles == 1);
  CHECK_THROWS_WITH_AS(explain_pixel(scene, front_camera(), size(8, 6), 8, 0),
                       doctest::Contains("x from 0 to 7 and y from 0 to 5"), Error);
  CHECK_THROWS_AS(explain_pixel(scene, front_camera(), size(8, 8), 0, -1), Error);
}
