// The z-pyramid of a picture: what the hierarchical method knows, read level by level, asked, and drawn.
#include <iostream>
#include <velum/velum.hpp>

int main() {
  const velum::Scene scene = velum::load_scene("builtin:house");
  const velum::Camera camera =
      velum::frame(scene.bounds(), velum::projection::two_point(), {.aspect = 4.0 / 3.0});
  const velum::Picture picture = velum::render(scene, camera, {.width = 640, .height = 480});

  const velum::Image<float> depth =
      velum::reversed_depth_of(picture);  // 1 near … 0 far; outlives the pyramid
  velum::ZPyramid pyramid;
  pyramid.build(depth.view());
  for (int i = 0; i < pyramid.levels(); ++i) {  // level 0 is the picture, the last is one value
    const velum::ImageView<const float> level = pyramid.level(i);
    std::cout << i << ": " << level.width << "x" << level.height << ", the middle is no farther than "
              << level.at(level.width / 2, level.height / 2) << '\n';
  }
  // Would anything show through in these 40x30 pixels if it were at reversed depth 0.01 or farther?
  const velum::PyramidAnswer answer = pyramid.is_hidden({300, 225, 40, 30}, 0.01f);
  std::cout << (answer.is_hidden ? "hidden, level " : "perhaps seen, level ") << answer.level << '\n';

  velum::write_png("pyramid.png", velum::draw_pyramid_sheet(pyramid));
  return answer.is_hidden ? 0 : 1;
}
