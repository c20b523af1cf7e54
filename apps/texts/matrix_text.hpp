#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <string>

namespace velum_app {

/// Four lines "    [ a  b  c  d ]", rows of the matrix, columns aligned at the right.
std::string matrix_text(const glm::dmat4& matrix);
/// The same with nine significant digits, for worked examples, indented by seven.
std::string long_matrix_text(const glm::dmat4& matrix);
/// "(x, y, z, w)"
std::string vector_text(const glm::dvec4& vector);

}  // namespace velum_app
