#include <cmath>
#include <utility>

#include "../base/floating_point.hpp"
#include "builtin.hpp"
#include "builtin_parameters.hpp"
#include "builtin_surface.hpp"

/// Shapes of revolution around the y axis. Their seam is at the back (-z): the texture's middle looks
/// forward. The last column of a lattice takes its angle from the first, so the seam closes bit by bit.
namespace velum::shapes {
namespace {

constexpr int k_most_segments = 65536;

/// The horizontal directions (x, z) of the columns 0 … segments, to the right seen from outside.
class Columns {
 public:
  explicit Columns(int segments) : segments_(segments), circle_(circle(segments)) {}

  int count() const { return segments_; }
  glm::dvec2 direction(int column) const {
    return turned(circle_[static_cast<std::size_t>(column % segments_)]);
  }
  /// Half-way between a column and the next.
  glm::dvec2 direction_after(int column) const {
    return turned(point_on_circle(2 * column + 1, 2 * segments_));
  }
  double u(double column) const { return column / segments_; }

 private:
  static glm::dvec2 turned(const glm::dvec2& cos_sin) { return {-cos_sin.y, -cos_sin.x}; }

  int segments_;
  std::vector<glm::dvec2> circle_;
};

/// From (x, z), a factor and y.
glm::dvec3 around(const glm::dvec2& direction, double radius, double y) {
  return {direction.x * radius, y, direction.y * radius};
}

/// A flat disc with a vertex in its middle, facing up (above) or down (below).
void add_cap(SurfaceBuilder& builder, const Columns& columns, double radius, double y, Apex facing) {
  const double up = facing == Apex::above ? 1.0 : -1.0;
  const glm::dvec3 normal(0.0, up, 0.0);
  const std::uint32_t centre = builder.vertex({{0.0, y, 0.0}, normal, {0.5, 0.5}});
  const std::uint32_t ring = add_lattice(builder, columns.count(), 0, [&](int column, int) {
    const glm::dvec2 direction = columns.direction(column);
    return SurfaceVertex{
        around(direction, radius, y), normal, {0.5 + 0.5 * direction.x, 0.5 - 0.5 * up * direction.y}};
  });
  add_fan(builder, ring, columns.count(), facing, [&](int) { return centre; });
}

}  // namespace

Mesh sphere(float radius, int segments, int rings) {
  const FloatingPointScope floating_point;
  require_length("sphere", "radius", radius);
  require_count("sphere", "segments", segments, 3, k_most_segments);
  require_count("sphere", "rings", rings, 2, k_most_segments);
  require_triangles("sphere", 2 * static_cast<std::int64_t>(segments) * (rings - 1));
  const double r = radius;
  const Columns columns(segments);
  SurfaceBuilder builder;
  // Between the poles: ring 1 … rings-1, counted from the south.
  const std::uint32_t south = add_lattice(builder, segments, rings - 2, [&](int column, int row) {
    const glm::dvec2 meridian = point_on_circle(row + 1, 2 * rings);
    const glm::dvec3 normal = around(columns.direction(column), meridian.y, -meridian.x);
    return SurfaceVertex{normal * r, normal, {columns.u(column), static_cast<double>(row + 1) / rings}};
  });
  // A pole for every column, so that its texture coordinate lies between those of the column.
  const auto pole = [&](double y, double v) {
    return [&builder, &columns, r, y, v](int column) {
      return builder.vertex({{0.0, y * r, 0.0}, {0.0, y, 0.0}, {columns.u(column + 0.5), v}});
    };
  };
  const auto north = south + static_cast<std::uint32_t>((rings - 2) * (segments + 1));
  add_fan(builder, south, segments, Apex::below, pole(-1.0, 0.0));
  add_fan(builder, north, segments, Apex::above, pole(1.0, 1.0));
  return builder.finish("sphere");
}

Mesh cylinder(float radius, float height, int segments) {
  const FloatingPointScope floating_point;
  require_length("cylinder", "radius", radius);
  require_length("cylinder", "height", height);
  require_count("cylinder", "segments", segments, 3, k_most_segments);
  const double top = 0.5 * static_cast<double>(height);
  const Columns columns(segments);
  SurfaceBuilder builder;
  add_lattice(builder, segments, 1, [&](int column, int row) {
    const glm::dvec2 direction = columns.direction(column);
    return SurfaceVertex{around(direction, radius, row == 0 ? -top : top),
                         around(direction, 1.0, 0.0),
                         {columns.u(column), row}};
  });
  add_cap(builder, columns, radius, top, Apex::above);
  add_cap(builder, columns, radius, -top, Apex::below);
  return builder.finish("cylinder");
}

Mesh cone(float radius, float height, int segments) {
  const FloatingPointScope floating_point;
  require_length("cone", "radius", radius);
  require_length("cone", "height", height);
  require_count("cone", "segments", segments, 3, k_most_segments);
  const double r = radius;
  const double h = height;
  const double slant = std::sqrt(r * r + h * h);
  const auto normal = [&](const glm::dvec2& direction) { return around(direction, h / slant, r / slant); };
  const Columns columns(segments);
  SurfaceBuilder builder;
  const std::uint32_t base = add_lattice(builder, segments, 0, [&](int column, int) {
    const glm::dvec2 direction = columns.direction(column);
    return SurfaceVertex{around(direction, r, -0.5 * h), normal(direction), {columns.u(column), 0.0}};
  });
  // The apex has no normal of its own: each column brings the one of its middle.
  add_fan(builder, base, segments, Apex::above, [&](int column) {
    return builder.vertex(
        {{0.0, 0.5 * h, 0.0}, normal(columns.direction_after(column)), {columns.u(column + 0.5), 1.0}});
  });
  add_cap(builder, columns, r, -0.5 * h, Apex::below);
  return builder.finish("cone");
}

Mesh torus(float major_radius, float minor_radius, int major_segments, int minor_segments) {
  const FloatingPointScope floating_point;
  require_length("torus", "major_radius", major_radius);
  require_length("torus", "minor_radius", minor_radius);
  require_below("torus", "minor_radius", minor_radius, "major_radius", major_radius);
  require_count("torus", "major_segments", major_segments, 3, k_most_segments);
  require_count("torus", "minor_segments", minor_segments, 3, k_most_segments);
  require_triangles("torus", 2 * static_cast<std::int64_t>(major_segments) * minor_segments);
  const double minor = minor_radius;
  const double major = major_radius;
  const Columns columns(major_segments);
  const std::vector<glm::dvec2> tube = circle(minor_segments);
  SurfaceBuilder builder;
  add_lattice(builder, major_segments, minor_segments, [&](int column, int row) {
    const glm::dvec2 direction = columns.direction(column);
    const glm::dvec2 section = tube[static_cast<std::size_t>(row % minor_segments)];
    return SurfaceVertex{around(direction, major + minor * section.x, minor * section.y),
                         around(direction, section.x, section.y),
                         {columns.u(column), static_cast<double>(row) / minor_segments}};
  });
  return builder.finish("torus");
}

}  // namespace velum::shapes
