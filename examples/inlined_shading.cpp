// Custom shading compiled into the pixel loop: a callable given as a template argument is inlined there, and
// several threads call it at once. It may read what it captures, and must not change anything.
#include <glm/geometric.hpp>
#include <velum/velum.hpp>

namespace {

/// Cool shades away from the light, warm ones towards it (Gooch et al. 1998).
struct WarmAndCool {
  glm::vec3 to_light;

  glm::vec4 operator()(const velum::SurfacePoint& point) const {
    const float warmth = 0.5f + 0.5f * glm::dot(point.shading_normal, to_light);
    const glm::vec3 cool(0.10f, 0.15f, 0.45f), warm(0.85f, 0.65f, 0.25f);
    return {cool * (1.0f - warmth) + warm * warmth, 1.0f};
  }
};

}  // namespace

int main() {
  velum::Scene scene;
  scene.add(velum::shapes::torus());
  const velum::Camera camera =
      velum::frame(scene.bounds(), velum::projection::perspective(), {.aspect = 640.0 / 480.0});
  velum::RenderSettings settings;
  settings.width = 640;
  settings.height = 480;

  const WarmAndCool shader{glm::normalize(glm::vec3(1.0f, 2.0f, 2.0f))};
  const velum::Picture picture = velum::render_with(scene, camera, settings, shader);
  velum::write_png("inlined_shading.png", picture.colour);

  // The same through a std::function, called for one point after the other on this thread: the same bytes.
  settings.shader = shader;
  const velum::Picture expected = velum::render(scene, camera, settings);
  for (int y = 0; y < picture.colour.height(); ++y) {
    for (int x = 0; x < picture.colour.width(); ++x) {
      if (!(picture.colour.at(x, y) == expected.colour.at(x, y))) return 1;
    }
  }
  return picture.coverage() > 0.1 ? 0 : 1;
}
