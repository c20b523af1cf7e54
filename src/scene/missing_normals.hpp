#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "load_scene.hpp"
#include "mesh.hpp"

namespace velum {

/// Scales to unit length. What has no direction (zero, NaN, infinite) becomes exactly zero.
glm::vec3 unit_or_zero(const glm::vec3& v);

/// The normal of the triangle, unit length, or zero for one without area.
glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// Gives a mesh straight from a file its normals: computed where there are none; else the file's, at unit
/// length, with a smooth one in place of each that has no direction.
/// @throws Error (read) when the result would break the memory bound
Mesh with_complete_normals(Mesh mesh, MissingNormals missing, std::size_t file_bytes,
                           const std::string& where);

/// What there is to say about positions that are NaN or infinite: nothing, or one sentence.
void note_positions_not_finite(std::span<const glm::vec3> positions, std::vector<std::string>& notes);

}  // namespace velum
