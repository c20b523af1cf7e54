#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <velum/velum.hpp>

using namespace velum;

namespace {

namespace fs = std::filesystem;

Scene moved_by(const Scene& scene, double offset) {
  Scene result = scene;
  for (std::uint32_t i = 0; i < scene.instances().size(); ++i) {
    glm::dmat4 matrix = scene.instances()[i].world_from_object;
    for (int axis = 0; axis < 3; ++axis) matrix[3][axis] += offset;
    result.set_world_from_object(i, matrix);
  }
  return result;
}

}  // namespace

TEST_CASE("raster and ray casting agree on the shared meshes, 10,000 units away too") {
  const fs::path data = VELUM_SHARED_DATA;
  if (!fs::exists(data)) {
    MESSAGE("the shared meshes are not beside the project: skipped");
    return;
  }
  RenderSettings settings;
  settings.width = 160;
  settings.height = 120;
  FrameOptions options;
  options.aspect = 160.0 / 120.0;
  for (const char* name : {"stanford-bunny.obj", "castle.ply", "sponza.ply"}) {
    CAPTURE(name);
    const Scene mesh = load_scene((data / name).string());
    for (const double offset : {0.0, 1e4}) {
      const Scene scene = moved_by(mesh, offset);
      for (const char* projection : {"perspective", "cabinet"}) {
        CAPTURE(offset);
        CAPTURE(projection);
        const Camera camera = frame(scene.bounds(), parse_projection(projection), options);
        const AgreementReport report = agree(scene, camera, settings);
        CHECK(report.of(Agreement::unexplained) == 0);
        CHECK(report.covered > 1000);
        CHECK(report.differing_share() < 0.03);
      }
    }
  }
}
