// Custom shading: any callable that turns a SurfacePoint into a linear colour. This one draws contour lines
// of equal height, as on a map, and darkens surfaces that turn away from the viewer.
#include <cmath>
#include <glm/geometric.hpp>
#include <velum/velum.hpp>

namespace {

glm::vec4 height_lines(const velum::SurfacePoint& point) {
  const double height = point.position.y * 20.0;
  const bool on_line = height - std::floor(height) < 0.15;
  const float facing = glm::dot(point.shading_normal, glm::vec3(point.to_viewer));
  const glm::vec3 colour = on_line ? glm::vec3(0.35f, 0.08f, 0.02f) : glm::vec3(0.75f, 0.7f, 0.5f);
  return {colour * (0.25f + 0.75f * facing), 1.0f};
}

}  // namespace

int main() {
  velum::Scene scene;
  scene.add(velum::shapes::torus());

  velum::RenderSettings settings;
  settings.width = 640;
  settings.height = 480;
  settings.shader = height_lines;

  const double aspect = 640.0 / 480.0;
  const velum::Camera camera =
      velum::frame(scene.bounds(), velum::projection::perspective(), {.aspect = aspect});
  const velum::Picture picture = velum::render(scene, camera, settings);
  velum::write_png("custom_shading.png", picture.colour);
  return picture.coverage() > 0.1 ? 0 : 1;
}
