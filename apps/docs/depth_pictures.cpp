// The house from far away under each depth format: z-fighting.
#include <glm/geometric.hpp>
#include <vector>

#include "depth_formats.hpp"
#include "paint.hpp"

namespace velum_docs {

using namespace velum;

namespace {

constexpr int panel_width = 196;
constexpr int panel_height = 147;
constexpr int caption = 22;

}  // namespace

FarHouse make_far_house() {
  Scene scene = load_scene("builtin:house");
  RenderSettings settings;
  settings.width = panel_width;
  settings.height = panel_height;
  settings.background = paper;
  settings.visibility = VisibilityMethod::scanline;
  FrameOptions options;
  options.aspect = static_cast<double>(panel_width) / panel_height;
  options.eye = glm::dvec3(34, 26, 48);
  options.target = glm::dvec3(0, 0.55, 0);
  options.near = 0.01;
  options.far = 1000.0;
  const Camera camera = frame(scene.points(), projection::perspective(), options);
  const double distance = glm::length(*options.eye - *options.target);
  return {std::move(scene), camera, settings, distance,
          "builtin:house --eye 34,26,48 --target 0,0.55,0 --near 0.01 --far 1000"};
}

Picture render_far_house(const FarHouse& house, DepthFormat format) {
  RenderSettings settings = house.settings;
  settings.depth_format = format;
  return render(house.scene, house.camera, settings);
}

Image<Rgba8> draw_fighting(const FarHouse& house) {
  std::vector<Image<Rgba8>> panels;
  for (const NamedFormat& named : depth_formats) {
    Canvas canvas(panel_width, panel_height + caption, paper);
    canvas.text({2, 4}, named.name, 2, ink);
    paint_image(canvas, render_far_house(house, named.format).colour, 0, caption);
    panels.push_back(canvas.picture());
  }
  return side_by_side(panels, 4);
}

}  // namespace velum_docs
