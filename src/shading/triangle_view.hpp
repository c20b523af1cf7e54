#pragma once

#include <array>
#include <glm/mat2x2.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "../projection/facing.hpp"
#include "../projection/viewport.hpp"
#include "../scene/scene.hpp"
#include "surface_point.hpp"
#include "texture_filter.hpp"

namespace velum {

/// What shading must know of the camera, the same for every triangle.
struct Viewer {
  Viewport viewport;
  glm::dvec4 eye{0.0, 0.0, 1.0, 0.0};  ///< (COP, 1) or (-DOP, 0), see eye_of()
  glm::dvec4 metric_depth_plane{0.0};  ///< see metric_depth_plane()
  TextureFilter texture_filter = TextureFilter::trilinear;
};

/// Unit direction from a world point to the viewer; zero if the point is the COP itself.
glm::dvec3 to_viewer_from(const glm::dvec3& position, const glm::dvec4& eye);

/// One visible primitive as one camera sees it: set up once, then evaluated at its pixels. Owns what it needs
/// except the material, which must outlive it. Vertex arrays are in the order of the mesh's triangle.
struct TriangleView {
  PrimitivePlace place;
  std::uint32_t primitive = 0;
  const Material* material = nullptr;
  Facing facing = Facing::front;
  double determinant = 0.0;            ///< homogeneous_determinant() of the clip-space vertices
  bool is_in_front = false;            ///< all vertices have w > 0
  int nearest = 0;                     ///< among vertices with w > 0 the one of largest reversed depth
  glm::dvec4 eye{0.0, 0.0, 1.0, 0.0};  ///< of the viewer
  TextureFilter texture_filter = TextureFilter::trilinear;
  std::array<glm::dvec4, 3> clip;           ///< homogeneous, unclipped
  std::array<glm::dvec3, 3> pixel;          ///< (x·w, y·w, w), x and y in pixels, y down
  std::array<glm::dvec2, 3> edge_gradient;  ///< of edge plane i, per pixel
  std::array<glm::dvec3, 3> world;
  std::array<double, 3> metric_depth;            ///< world units
  glm::vec3 geometric_normal{0.0f};              ///< world space, unit length (0 without area), viewer's side
  std::array<glm::vec3, 3> normals;              ///< world space, unit length, turned when back-facing
  std::array<glm::vec4, 3> colours;              ///< vertex colour · base colour, linear, straight alpha
  std::array<glm::vec2, 3> texture_coordinates;  ///< 0 where the mesh has none
};

/// Perspective-correct barycentric coordinates, sum 1.
struct Barycentrics {
  glm::dvec3 exact{0.0};    ///< of the triangle's plane: negative outside the triangle
  glm::dvec3 clamped{0.0};  ///< negative ones set to 0 and the rest scaled to sum 1: a point of the triangle
};

/// Sets a primitive up for attribute evaluation.
/// @pre place exists in the scene; its clip-space vertices are finite
/// @param clip_from_object  ViewingTransform::clip_from_object() of the place's instance
TriangleView view_triangle(const Scene& scene, const PrimitivePlace& place,
                           const glm::dmat4& clip_from_object, const Viewer& viewer);

/// Barycentric coordinates at a position in the picture (pixels, y down, centres at +0.5). Right also with
/// vertices at w ≤ 0. Of a triangle seen exactly edge-on, those of its nearest vertex.
/// Source: Olano & Greer 1997: the edge planes are the rows of the adjugate of the columns (x, y, w); here
/// they are evaluated with the origin moved to (px, py), which keeps small triangles accurate.
Barycentrics barycentrics_at(const TriangleView& triangle, double px, double py);

/// How the mesh's texture coordinates change per pixel to the right (column 0) and down (column 1) where the
/// triangle's plane is seen at (px, py); exact, also with vertices at w ≤ 0. Zero for a triangle seen edge-on
/// and on the plane's horizon, where barycentrics_at() gives a vertex.
/// Source: Heckbert 1989, "Fundamentals of Texture Mapping and Image Warping": the quotient rule on
/// u = Σ uᵢ·βᵢ / Σ βᵢ, with the edge planes βᵢ.
glm::dmat2 texture_derivatives_at(const TriangleView& triangle, double px, double py);

/// Everything a shader may want to know of the triangle at the centre of pixel (x, y) of the whole picture.
/// A covered centre may lie up to √2/512 pixel outside the true triangle (snapping): attributes are then
/// those of a point on the triangle close by, never extrapolated.
/// @param reversed_depth  as the visibility buffer has it
SurfacePoint surface_point(const TriangleView& triangle, int x, int y, float reversed_depth);
/// The same elsewhere in the pixel.
/// @param at  pixels, y down, centres at +0.5
SurfacePoint surface_point(const TriangleView& triangle, const glm::dvec2& at, int x, int y,
                           float reversed_depth);

}  // namespace velum
