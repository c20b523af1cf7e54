#include "sheet.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "../base/floating_point.hpp"
#include "../image/visibility_buffer.hpp"
#include "../pipeline/memory_need.hpp"
#include "../pipeline/render.hpp"
#include "canvas.hpp"
#include "sheet_layout.hpp"

namespace velum {
namespace {

constexpr Rgba8 ink{40, 44, 52, 255};
constexpr Rgba8 faint{200, 204, 210, 255};

/// Copies a view into its place, but for one pixel all around, where its frame is drawn.
void copy(const Image<Rgba8>& from, const Rect& rect, Image<Rgba8>& to) {
  for (int y = 1; y < rect.height - 1; ++y) {
    std::copy_n(from.row(y) + 1, rect.width - 2, to.row(rect.top + y) + rect.left + 1);
  }
}

/// Whether the surface steps back by more than `step` between pixel 1 and the next: the second difference of
/// the depth, so that a plane seen at a grazing angle is no step.
bool is_step(double before, double depth0, double depth1, double step) {
  const double bend = (depth1 - depth0) - (depth0 - before);
  return bend > step || bend < -step;
}

/// Whether an edge of the object runs between pixel (x, y) and its neighbour (x + dx, y + dy): one shows the
/// background, or the surface turns, or it steps back by more than `step`.
bool is_edge(const Picture& picture, int x, int y, int dx, int dy, double step) {
  const auto seen = [&](int i, int j) { return picture.object_id.at(i, j) != no_primitive; };
  const int x1 = x + dx, y1 = y + dy;
  if (seen(x, y) != seen(x1, y1)) return true;
  if (!seen(x, y)) return false;
  constexpr float cosine_of_turn = 0.9f;
  if (glm::dot(picture.normal.at(x, y), picture.normal.at(x1, y1)) < cosine_of_turn) return true;
  if (x < dx || y < dy || !seen(x - dx, y - dy)) return false;
  return is_step(picture.metric_depth.at(x - dx, y - dy), picture.metric_depth.at(x, y),
                 picture.metric_depth.at(x1, y1), step);
}

/// Draws the object's edges as a draughtsman does: a view along an axis would show steps of one colour as one
/// surface.
void draw_edges(Picture& picture, double step) {
  const int width = picture.colour.width(), height = picture.colour.height();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool right = x + 1 < width && is_edge(picture, x, y, 1, 0, step);
      const bool below = y + 1 < height && is_edge(picture, x, y, 0, 1, step);
      if (right || below) picture.colour.at(x, y) = ink;
    }
  }
}

Image<Rgba8> rendered(const Scene& scene, const SheetView& view, const SheetOptions& options) {
  RenderSettings settings;
  settings.width = view.rect.width;
  settings.height = view.rect.height;
  settings.background = options.background;
  settings.shading = options.shading;
  Picture picture = render(scene, view.camera, settings);
  const glm::dvec3 size = scene.bounds().size();
  constexpr double visible_step = 0.01;  // of the scene's longest edge
  draw_edges(picture, visible_step * std::max({size.x, size.y, size.z}));
  return picture.colour;
}

/// A frame around each view's cell, its name below it, and what kind of sheet this is.
Image<Rgba8> lettering(const std::vector<SheetView>& views, const SheetOptions& options) {
  Canvas canvas(options.width, options.height, options.background);
  for (const SheetView& view : views) {
    const Rect& r = view.rect;
    const glm::dvec2 corners[] = {{r.left + 0.5, r.top + 0.5},
                                  {r.right() - 0.5, r.top + 0.5},
                                  {r.right() - 0.5, r.bottom() + label_height - 0.5},
                                  {r.left + 0.5, r.bottom() + label_height - 0.5}};
    canvas.outline(corners, 1.0, faint);
    canvas.text({r.left + 0.5 * r.width, r.bottom() + 3.0}, view.name, 2, ink, TextAnchor::middle);
  }
  const char* const angle = options.angle == SheetAngle::first ? "first angle" : "third angle";
  canvas.text({12.0, options.height - 20.0}, angle, 2, ink);
  return canvas.picture();
}

}  // namespace

Sheet draw_sheet(const Scene& scene, const SheetOptions& options) {
  const FloatingPointScope floating_point;
  // The canvas, what it gives, and the sheet; each view is checked when it is rendered.
  const std::uint64_t pixel_bytes = sizeof(glm::vec4) + 2 * sizeof(Rgba8);
  memory_left(pixel_bytes * Image<std::uint8_t>::bytes_for(options.width, options.height), {});
  Sheet sheet;
  sheet.views = place_views(scene, options);
  sheet.picture = lettering(sheet.views, options);
  for (const SheetView& view : sheet.views) {
    copy(rendered(scene, view, options), view.rect, sheet.picture);
    sheet.pixels_per_unit = std::max(sheet.pixels_per_unit, view.pixels_per_unit);
  }
  return sheet;
}

}  // namespace velum
