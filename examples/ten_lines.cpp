#include <velum/velum.hpp>

int main(int argc, char** argv) {
  const velum::Scene scene = velum::load_scene(argc > 1 ? argv[1] : "builtin:house");
  const velum::Camera camera =
      velum::frame(scene.bounds(), velum::projection::cabinet(), {.aspect = 16.0 / 9.0});
  const velum::Picture picture = velum::render(scene, camera, {.width = 1920, .height = 1080});
  velum::write_png("ten_lines.png", picture.colour);
}
