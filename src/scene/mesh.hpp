#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "../base/aabb.hpp"
#include "array.hpp"

namespace velum {

/// Triangles, segments and points over shared vertices, in object space. Counter-clockwise triangles face
/// outwards; segments and points have no sides.
/// The optional arrays are empty or as long as `positions`.
struct Mesh {
  std::string name;
  Array<glm::vec3> positions;            ///< object space
  Array<glm::vec3> normals;              ///< optional; unit length. Segments and points are lit by them, or
                                         ///< show their colour unlit where there are none (or 0)
  Array<glm::vec2> texture_coordinates;  ///< optional; (0,0) is the lower left of the texture
  Array<glm::vec4> colours;       ///< optional; linear, straight alpha, multiplied with the base colour
  Array<glm::uvec3> triangles;    ///< vertex indices
  Array<glm::uvec2> segments{};   ///< vertex indices; drawn RenderSettings::line_width wide
  Array<std::uint32_t> points{};  ///< vertex indices; drawn as squares of RenderSettings::point_size

  /// Triangles, segments and points together.
  std::size_t primitive_count() const { return triangles.size() + segments.size() + points.size(); }
};

/// The box around all finite positions; empty for none.
Aabb bounds(const Mesh& mesh);

/// Demands that indices are in range and optional arrays have the right length.
/// @throws Error (usage) that names the mesh, the array and the first offending index
void validate(const Mesh& mesh);

/// Area-weighted smooth vertex normals (each face normal's length is twice its area), one per position.
/// Vertices without a triangle of area get (0, 0, 1). Triangles with a vertex that is not finite do not
/// count.
/// @throws Error (usage) as validate
std::vector<glm::vec3> smooth_normals(const Mesh& mesh);

/// The same surface with no shared vertices: every triangle has three of its own, with the face's normal;
/// one without area gets (0, 0, 1). Segments and points are left out: they have no face. @throws Error
/// (usage) as validate; Error (limit) above 2³²/3 triangles
Mesh with_flat_normals(const Mesh& mesh);

}  // namespace velum
