#include <algorithm>
#include <array>

#include "../base/error.hpp"
#include "../base/floating_point.hpp"
#include "../projection/frame.hpp"
#include "../projection/projection.hpp"
#include "sheet.hpp"
#include "sheet_layout.hpp"

namespace velum {
namespace {

/// A view's cell in the table of views.
struct Cell {
  const char* name;
  int column;
  int row;
};

/// First angle has every view on the far side of the front view from where it was taken; third angle on the
/// same side.
std::vector<Cell> cells_of(const SheetOptions& options) {
  const bool first = options.angle == SheetAngle::first;
  if (options.layout == SheetLayout::four) {
    if (first) return {{"right", 0, 0}, {"front", 1, 0}, {"top", 1, 1}, {"perspective", 0, 1}};
    return {{"top", 0, 0}, {"perspective", 1, 0}, {"front", 0, 1}, {"right", 1, 1}};
  }
  const char* const left_of_front = first ? "right" : "left";
  const char* const right_of_front = first ? "left" : "right";
  const char* const above_front = first ? "bottom" : "top";
  const char* const below_front = first ? "top" : "bottom";
  return {{above_front, 1, 0},    {left_of_front, 0, 1}, {"front", 1, 1},
          {right_of_front, 2, 1}, {"back", 3, 1},        {below_front, 1, 2}};
}

/// Width and height of what a view shows, in world units: the extents of the scene's box along the picture's
/// axes.
glm::dvec2 extent_of(const Aabb& box, const Camera& camera) {
  const glm::dmat4 camera_from_world = camera.viewing_transform(1.0).clip_from_world();
  glm::dvec2 low(1e300), high(-1e300);
  for (const glm::dvec3& corner : box.corners()) {
    const glm::dvec4 p = camera_from_world * glm::dvec4(corner, 1.0);
    low = glm::min(low, glm::dvec2(p));
    high = glm::max(high, glm::dvec2(p));
  }
  return (high - low) * (0.5 * std::get<ParallelWindow>(camera.lens()).height);
}

struct Table {
  std::vector<double> columns, rows;  ///< world units
  double columns_sum() const { return sum(columns); }
  double rows_sum() const { return sum(rows); }

 private:
  static double sum(const std::vector<double>& values) {
    double total = 0.0;
    for (const double value : values) total += value;
    return total;
  }
};

Camera framed(const Aabb& box, const char* name, UpAxis up) {
  FrameOptions options;
  options.z_up = up == UpAxis::z;
  options.aspect = 1.0;
  return frame(box, parse_projection(name), options);
}

bool is_perspective(const Cell& cell) {
  return std::string_view(cell.name) == "perspective";
}

/// Every column is as wide as its widest view, every row as high as its highest.
Table measure(const std::vector<Cell>& cells, const Aabb& box, UpAxis up) {
  Table table;
  for (const Cell& cell : cells) {
    table.columns.resize(std::max(table.columns.size(), static_cast<std::size_t>(cell.column) + 1), 0.0);
    table.rows.resize(std::max(table.rows.size(), static_cast<std::size_t>(cell.row) + 1), 0.0);
    if (is_perspective(cell)) continue;
    const glm::dvec2 extent = extent_of(box, framed(box, cell.name, up));
    double& column = table.columns[static_cast<std::size_t>(cell.column)];
    double& row = table.rows[static_cast<std::size_t>(cell.row)];
    column = std::max(column, extent.x);
    row = std::max(row, extent.y);
  }
  return table;
}

/// Cuts `length` pixels into parts: each its extent in the common scale and an equal share of what is left.
std::vector<int> cut(const std::vector<double>& extents, double scale, int length) {
  double used = 0.0;
  for (const double extent : extents) used += extent * scale;
  const double free = (length - used) / static_cast<double>(extents.size());
  std::vector<int> ends{0};
  double end = 0.0;
  for (const double extent : extents) {
    end += extent * scale + free;
    ends.push_back(static_cast<int>(end + 0.5));
  }
  ends.back() = length;
  return ends;
}

/// A camera that sees the box's middle in the sheet's scale.
Camera scaled(const Camera& framed_camera, const Rect& rect, double scale) {
  ParallelWindow window = std::get<ParallelWindow>(framed_camera.lens());
  window.height = rect.height / scale;
  return Camera::parallel(framed_camera.pose(), window, framed_camera.near(), framed_camera.far());
}

Camera camera_of(const Cell& cell, const Aabb& box, const Scene& scene, const Rect& rect, double scale) {
  if (!is_perspective(cell)) return scaled(framed(box, cell.name, scene.up), rect, scale);
  FrameOptions options;
  options.z_up = scene.up == UpAxis::z;
  options.aspect = static_cast<double>(rect.width) / rect.height;
  return frame(scene.points(), projection::perspective(), options);
}

Aabb box_of(const Scene& scene) {
  const Aabb bounds = scene.bounds();
  return bounds.is_empty() ? Aabb{glm::dvec3(-0.5), glm::dvec3(0.5)} : bounds;
}

}  // namespace

std::vector<SheetView> place_views(const Scene& scene, const SheetOptions& options) {
  const FloatingPointScope floating_point;
  const std::vector<Cell> cells = cells_of(options);
  const Aabb box = box_of(scene);
  const Table table = measure(cells, box, scene.up);
  const double gap = 2.0 * sheet_margin;
  const double free_width = options.width - gap * static_cast<double>(table.columns.size());
  const double free_height =
      options.height - sheet_footer - (gap + label_height) * static_cast<double>(table.rows.size());
  if (free_width < 16.0 * static_cast<double>(table.columns.size()) ||
      free_height < 16.0 * static_cast<double>(table.rows.size())) {
    throw Error(ErrorKind::usage,
                "a sheet of " + std::to_string(options.width) + "x" + std::to_string(options.height) +
                    " pixels is too small for its views",
                "size", "make it larger, e.g. 1200x900");
  }
  const double columns = table.columns_sum(), rows = table.rows_sum();
  // A flat scene has no extent in one direction; a point in none.
  double scale =
      std::min(columns > 0.0 ? free_width / columns : 1e300, rows > 0.0 ? free_height / rows : 1e300);
  if (scale == 1e300) scale = 1.0;
  const std::vector<int> x = cut(table.columns, scale, options.width);
  const std::vector<int> y = cut(table.rows, scale, options.height - sheet_footer);
  std::vector<SheetView> views;
  for (const Cell& cell : cells) {
    const auto column = static_cast<std::size_t>(cell.column), row = static_cast<std::size_t>(cell.row);
    const Rect rect{x[column], y[row], x[column + 1] - x[column], y[row + 1] - y[row] - label_height};
    views.push_back(
        {cell.name, rect, camera_of(cell, box, scene, rect, scale), is_perspective(cell) ? 0.0 : scale});
  }
  return views;
}

}  // namespace velum
