#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>

namespace velum {

/// Checks of what a person gave; each throws Error (usage) that names the parameter and prints its value.
void check_finite(double value, const std::string& name);
void check_finite(const glm::dvec2& value, const std::string& name);
void check_finite(const glm::dvec3& value, const std::string& name);
void check_positive(double value, const std::string& name);              ///< finite and > 0
void check_direction(const glm::dvec3& value, const std::string& name);  ///< finite and not zero
void check_opening_angle(double radians, const std::string& name);       ///< in (0, π)
/// Whether the matrix is finite and regular to double precision, whatever the scale of its rows and columns.
bool is_regular(const glm::dmat4& matrix);
/// Finite, and regular to double precision whatever the scale of its rows and columns.
void check_regular(const glm::dmat4& matrix, const std::string& name);

/// Shortest decimal text that reads back to the same number; independent of the locale.
std::string text_of(double value);
std::string text_of(const glm::dvec3& value);

}  // namespace velum
