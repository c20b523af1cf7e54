#include <velum/velum.hpp>

// What a newcomer writes first; succeeds when the cube is seen and its picture is written.
int main() {
  const velum::Scene scene = velum::load_scene("builtin:cube");
  const velum::Camera camera =
      velum::frame(scene.bounds(), velum::projection::cabinet(), {.aspect = 4.0 / 3.0});
  const velum::Picture picture = velum::render(scene, camera, {.width = 160, .height = 120});
  velum::write_png("cube.png", picture.colour);
  return picture.coverage() > 0.2 && picture.coverage() < 0.9 ? 0 : 1;
}
