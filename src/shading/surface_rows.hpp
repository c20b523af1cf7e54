#pragma once

/// The vector versions of surface_point(), for triangles, and of blinn_phong(): over neighbouring pixels of a
/// row. The scalar ones are their references; the results are the same to the bit.

#include <cstddef>
#include <cstdint>

#include "../base/isa.hpp"

namespace velum {

/// The most pixels in a SurfaceRow.
inline constexpr std::size_t most_row_pixels = 64;
/// Room for a last vector that reaches beyond.
inline constexpr std::size_t row_room = most_row_pixels + 8;

/// A TriangleView as the kernels read it: an attribute is its value at vertex 0 and the differences of
/// vertices 1 and 2 to it, see interpolate().
struct TrianglePlanes {
  double pixel[3][3];      ///< (x·w, y·w, w) of the vertices, pixels
  double nearest[3];       ///< the barycentric coordinates of the nearest vertex
  double world[3][3];      ///< of each axis
  double metric_depth[3];  ///< world units
  double lowest, highest;  ///< metric depths of the vertices
  double eye[3];           ///< where the viewer stands, or the direction to it
  float normal[3][3];      ///< of each axis, world space, on the viewer's side
  float geometric_normal[3];
  float colour[4][3];     ///< of each channel, linear, straight alpha
  float highlight[3][3];  ///< of each channel of `colour`, what no texture colours
  bool has_highlight;
  double texture[2][3];        ///< of each texture coordinate, at the vertices
  double edge_gradient[3][2];  ///< of each edge plane, per pixel to the right and down
  bool is_texture_constant;    ///< all vertices have the same coordinates
  bool is_in_front;            ///< all vertices have w > 0
  bool has_place;              ///< the viewer stands somewhere (perspective)
};

/// What surfaces show along a row; see SurfacePoint.
struct SurfaceRow {
  alignas(64) double position[3][row_room];
  alignas(64) double to_viewer[3][row_room];
  alignas(64) double metric_depth[row_room];
  alignas(64) float barycentric[3][row_room];
  alignas(64) float normal[3][row_room];  ///< the shading normal
  alignas(64) float colour[4][row_room];
  alignas(64) double texture_at[2][row_room];  ///< the mesh's coordinates
  alignas(64) double texture_dx[2][row_room];  ///< their change per pixel to the right
  alignas(64) double texture_dy[2][row_room];  ///< their change per pixel down
  alignas(64) float texel[4][row_room];        ///< see TextureRow
};

/// Which of them are wanted.
struct SurfaceNeeds {
  bool viewer = false;  ///< position and to_viewer
  bool metric_depth = false;
  bool normal = false;
  bool colour = false;
  bool texture = false;
};

struct SurfaceWork {
  const TrianglePlanes* triangle;
  int x;  ///< pixel of the whole picture at index 0 of the row
  int y;
  std::size_t begin;  ///< indices of the row; those up to 7 beyond the end are overwritten, too
  std::size_t end;
  SurfaceNeeds needs;
  SurfaceRow* row;
};
/// Fills what is needed, and the barycentric coordinates.
/// @pre the triangle's determinant is not 0
using InterpolateSurface = void (*)(const SurfaceWork& work);

/// One light; `towards` is a unit direction, or a place in world space.
struct RowLight {
  double towards[3];
  float radiance[3];
  bool is_place;
};

struct LightingWork {
  const RowLight* lights;
  std::size_t light_count;
  float ambient[3];  ///< light · material
  float diffuse[3];
  float specular[3];
  double shininess;
  std::size_t begin;  ///< indices of the row, as above
  std::size_t end;
  SurfaceRow* row;  ///< colour: from the surface's own to the lit one, alpha kept
};
using LightRow = void (*)(const LightingWork& work);

/// The kernels for an instruction set. @pre is_available(isa), and not `reference`
InterpolateSurface interpolate_surface_kernel(Isa isa);
LightRow light_row_kernel(Isa isa);

}  // namespace velum
