// What the camera sees: as fine as the page is wide, and on the small picture, with the triangle over both.
#include <vector>

#include "blocks.hpp"
#include "paint.hpp"

namespace velum_docs {
namespace {

using namespace velum;

constexpr int scale = 15;  ///< a pixel of the small picture on the page
constexpr int caption = 24;

/// The outlines of the triangle, or of what clipping left of it, in pixels of the small picture.
std::vector<glm::dvec2> outline(const Subject& subject, bool clipped) {
  std::vector<glm::dvec2> corners;
  if (clipped) {
    for (const PlacedPoint& point : subject.triangle.polygon) corners.push_back(point.pixel);
  } else {
    for (const VertexTrace& vertex : subject.triangle.vertices)
      corners.push_back(place_on_picture(vertex.clip, subject.viewport()).pixel);
  }
  return corners;
}

Image<Rgba8> render_at(const Subject& subject, int factor) {
  RenderSettings settings = subject.settings;
  settings.width *= factor;
  settings.height *= factor;
  return render(subject.scene, subject.camera, settings).colour;
}

Image<Rgba8> panel(const Subject& subject, int factor, const std::string& title) {
  constexpr int right = 3 * scale;  // where the triangle sticks out
  const int width = subject.settings.width * scale, height = subject.settings.height * scale;
  Canvas canvas(width + right, height + caption, paper);
  paint_image(canvas, render_at(subject, factor), 0, caption, scale / factor);
  canvas.text({2, 5}, title, 2, ink);
  const glm::dvec2 corner(0, caption);
  const auto on_page = [&](std::vector<glm::dvec2> points) {
    for (glm::dvec2& p : points) p = corner + static_cast<double>(scale) * p;
    return points;
  };
  canvas.outline(
      std::vector<glm::dvec2>{
          {0, caption}, {width, caption}, {width, height + caption - 1}, {0, height + caption - 1}},
      1.0, faint);
  const std::vector<glm::dvec2> whole = on_page(outline(subject, false));
  canvas.outline(whole, 1.5, blue);
  canvas.outline(on_page(outline(subject, true)), 2.5, paper);
  canvas.outline(on_page(outline(subject, true)), 1.5, red);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    canvas.disc(whole[i], 4.0, ink);
    canvas.text(whole[i] + glm::dvec2(i == 2 ? -12 : 0, i == 2 ? -16 : 10), std::to_string(i), 2, ink,
                TextAnchor::middle);
  }
  return canvas.picture();
}

}  // namespace

Image<Rgba8> draw_scene(const Subject& subject) {
  const Image<Rgba8> panels[] = {panel(subject, scale, "480x360"), panel(subject, 1, "32x24")};
  return side_by_side(panels, 6);
}

}  // namespace velum_docs
