#include "../base/floating_point.hpp"
#include "builtin.hpp"
#include "builtin_prism.hpp"
#include "builtin_surface.hpp"

/// The house is a few closed solids that reach into each other; no two of their faces lie in one plane, so no
/// pixel has to choose between equal depths.
namespace velum::shapes {
namespace {

// Linear colours.
constexpr glm::vec3 k_wall{0.80f, 0.70f, 0.52f};
constexpr glm::vec3 k_roof{0.50f, 0.12f, 0.07f};
constexpr glm::vec3 k_chimney{0.30f, 0.17f, 0.13f};
constexpr glm::vec3 k_door{0.20f, 0.10f, 0.05f};
constexpr glm::vec3 k_window{0.18f, 0.36f, 0.52f};

constexpr double k_half_width = 0.5;
constexpr double k_half_depth = 0.7;
constexpr double k_eaves = 0.6;
constexpr double k_ridge = 1.0;
constexpr double k_slope = (k_ridge - k_eaves) / k_half_width;

void add_walls(SurfaceBuilder& builder) {
  Prism walls;
  walls.outline = {{-k_half_width, 0.0},
                   {k_half_width, 0.0},
                   {k_half_width, k_eaves},
                   {0.0, k_ridge},
                   {-k_half_width, k_eaves}};
  walls.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  walls.back = -k_half_depth;
  walls.front = k_half_depth;
  builder.paint(k_wall);
  add_prism(builder, walls);
}

/// A bent slab that holds the gable's upper edge inside and hangs over on all sides.
void add_roof(SurfaceBuilder& builder) {
  constexpr double overhang = 0.12;
  constexpr double below = 0.02, above = 0.05;  // of the gable's edge, upright
  constexpr double x = k_half_width + overhang;
  constexpr double y = k_ridge - k_slope * x;
  Prism roof;
  roof.outline = {{-x, y - below}, {0.0, k_ridge - below}, {x, y - below},
                  {x, y + above},  {0.0, k_ridge + above}, {-x, y + above}};
  roof.triangles = {{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}};
  roof.back = -k_half_depth - overhang;
  roof.front = k_half_depth + overhang;
  builder.paint(k_roof);
  add_prism(builder, roof);
}

void add_door_and_windows(SurfaceBuilder& builder) {
  constexpr double inside = 0.05, outside = 0.015;  // of the wall's face
  builder.paint(k_door);
  add_box(builder, {-0.11, 0.01, k_half_depth - inside}, {0.11, 0.40, k_half_depth + outside});
  builder.paint(k_window);
  add_box(builder, {-0.09, 0.58, k_half_depth - inside}, {0.09, 0.74, k_half_depth + outside});
  for (const double side : {-1.0, 1.0}) {
    const double a = side * (k_half_width - inside);
    const double b = side * (k_half_width + outside);
    for (const double z : {-0.35, 0.35}) {
      add_box(builder, {a < b ? a : b, 0.22, z - 0.12}, {a < b ? b : a, 0.44, z + 0.12});
    }
  }
}

}  // namespace

Mesh house() {
  const FloatingPointScope floating_point;
  SurfaceBuilder builder;
  add_walls(builder);
  add_roof(builder);
  builder.paint(k_chimney);
  add_box(builder, {0.17, 0.55, -0.38}, {0.33, 1.18, -0.20});
  add_door_and_windows(builder);
  return builder.finish("house");
}

}  // namespace velum::shapes
