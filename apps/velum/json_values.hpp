#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <nlohmann/json.hpp>
#include <velum/velum.hpp>

namespace velum_app {

using Json = nlohmann::ordered_json;

/// [x, y, z], [x, y, z, w]
Json json_of(const glm::dvec3& vector);
Json json_of(const glm::dvec4& vector);
/// [[row 0], [row 1], [row 2], [row 3]]
Json json_of(const glm::dmat4& matrix);
/// [{"name", "meaning", "matrix"}, …] in the order of application
Json json_of(const velum::StageList& stages);
/// Where the camera stands and what it sees.
Json json_of(const velum::Camera& camera);

/// Indented text with a line break at the end.
std::string json_text(const Json& json);

}  // namespace velum_app
