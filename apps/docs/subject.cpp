#include "subject.hpp"

namespace velum_docs {

using namespace velum;

namespace {

/// A triangle of the roof: the picture's right edge cuts it and the chimney hides a part of it.
constexpr std::uint32_t followed = 30;
constexpr int pixel_x = 25;
constexpr int pixel_y = 9;

constexpr const char* command_line =
    "builtin:house --eye 1.7,1.3,2.4 --target -0.15,0.75,0.2 \\\n"
    "  --fov 28 --near 1.5 --far 5 --size 32x24";

FrameOptions framing() {
  FrameOptions options;
  options.aspect = 32.0 / 24.0;
  options.eye = glm::dvec3(1.7, 1.3, 2.4);
  options.target = glm::dvec3(-0.15, 0.75, 0.2);
  options.vertical_angle = radians(28.0);
  options.near = 1.5;
  options.far = 5.0;
  return options;
}

}  // namespace

Subject make_subject() {
  Scene scene = load_scene("builtin:house");
  const Camera camera = frame(scene.points(), projection::perspective(), framing());
  RenderSettings settings;
  settings.width = 32;
  settings.height = 24;
  settings.clip = ClipPolicy::exact;
  settings.background = {255, 255, 255, 255};
  const TriangleTrace triangle = trace_triangle(scene, camera, settings, followed);
  const std::array<glm::dvec4, 3>& v = triangle.assembled.vertices;
  const PixelExplanation pixel = explain_pixel(scene, camera, settings, pixel_x, pixel_y);
  return {std::move(scene),
          camera,
          settings,
          camera.viewing_transform(framing().aspect),
          triangle,
          trace_clipping(v[0], v[1], v[2]),
          pixel,
          command_line};
}

}  // namespace velum_docs
