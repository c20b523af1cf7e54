#include "../base/floating_point.hpp"
#include "builtin.hpp"
#include "builtin_parameters.hpp"
#include "builtin_prism.hpp"
#include "builtin_surface.hpp"

namespace velum::shapes {
namespace {

Mesh centred_box(const char* name, const glm::dvec3& size) {
  SurfaceBuilder builder;
  add_box(builder, -0.5 * size, 0.5 * size);
  return builder.finish(name);
}

/// A flight of steps seen from its right side, rising to the right; centred.
std::vector<glm::dvec2> stairs_outline(int steps, double rise, double tread) {
  const double width = steps * tread;
  const double height = steps * rise;
  const auto x = [&](int k) { return k * tread - 0.5 * width; };
  const auto y = [&](int k) { return k * rise - 0.5 * height; };
  std::vector<glm::dvec2> outline = {{x(0), y(0)}, {x(steps), y(0)}, {x(steps), y(steps)}};
  for (int k = steps - 1; k > 0; --k) {
    outline.emplace_back(x(k), y(k + 1));
    outline.emplace_back(x(k), y(k));
  }
  outline.emplace_back(x(0), y(1));
  return outline;
}

/// From corner 1 (the lowest under the highest step), which sees the whole outline.
std::vector<glm::uvec3> stairs_triangles(std::uint32_t corners) {
  std::vector<glm::uvec3> triangles;
  for (std::uint32_t i = 2; i < corners; ++i) triangles.emplace_back(1, i, (i + 1) % corners);
  return triangles;
}

}  // namespace

Mesh cube(float edge) {
  const FloatingPointScope floating_point;
  require_length("cube", "edge", edge);
  return centred_box("cube", glm::dvec3(edge));
}

Mesh box(float width, float height, float depth) {
  const FloatingPointScope floating_point;
  require_length("box", "width", width);
  require_length("box", "height", height);
  require_length("box", "depth", depth);
  return centred_box("box", {width, height, depth});
}

Mesh grid(float size, int cells) {
  const FloatingPointScope floating_point;
  require_length("grid", "size", size);
  require_count("grid", "cells", cells, 1, 4096);
  const auto coordinate = [&](int k) { return static_cast<double>(size) * (2 * k - cells) / (2.0 * cells); };
  SurfaceBuilder builder;
  add_lattice(builder, cells, cells, [&](int column, int row) {
    return SurfaceVertex{{coordinate(column), 0.0, -coordinate(row)},
                         {0.0, 1.0, 0.0},
                         {static_cast<double>(column) / cells, static_cast<double>(row) / cells}};
  });
  return builder.finish("grid");
}

Mesh stairs(int steps, float width, float rise, float tread) {
  const FloatingPointScope floating_point;
  require_count("stairs", "steps", steps, 1, 65536);
  require_length("stairs", "width", width);
  require_length("stairs", "rise", rise);
  require_length("stairs", "tread", tread);
  Prism prism;
  prism.right = {0.0, 0.0, -1.0};  // the front of the outline looks towards +x
  prism.outline = stairs_outline(steps, rise, tread);
  prism.triangles = stairs_triangles(static_cast<std::uint32_t>(prism.outline.size()));
  prism.front = 0.5 * static_cast<double>(width);
  prism.back = -prism.front;
  SurfaceBuilder builder;
  add_prism(builder, prism);
  return builder.finish("stairs");
}

Mesh letter_f() {
  const FloatingPointScope floating_point;
  // Whole sixteenths, so that every coordinate is exact.
  constexpr double left = -0.3125, stem = -0.125, middle_bar = 0.1875, right = 0.3125;
  constexpr double bottom = -0.5, middle_lower = -0.0625, middle_upper = 0.125, top_lower = 0.3125, top = 0.5;
  Prism prism;
  prism.outline = {{left, bottom},
                   {stem, bottom},
                   {stem, middle_lower},
                   {middle_bar, middle_lower},
                   {middle_bar, middle_upper},
                   {stem, middle_upper},
                   {stem, top_lower},
                   {right, top_lower},
                   {right, top},
                   {left, top}};
  prism.triangles = {{9, 0, 1}, {9, 1, 2}, {9, 2, 5}, {9, 5, 6}, {2, 3, 4}, {2, 4, 5}, {6, 7, 8}, {6, 8, 9}};
  prism.back = -0.125;
  prism.front = 0.125;
  SurfaceBuilder builder;
  // The solid alone equals its mirror image in z; its colours do not.
  builder.paint({0.85f, 0.28f, 0.08f});
  add_front(builder, prism);
  builder.paint({0.16f, 0.22f, 0.32f});
  add_back(builder, prism);
  add_sides(builder, prism);
  return builder.finish("letter-f");
}

}  // namespace velum::shapes
