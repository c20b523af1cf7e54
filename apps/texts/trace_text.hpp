#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <velum/velum.hpp>

namespace velum_app {

/// Numbers of a worked example: enough digits that the next line can be computed from this one.
std::string long_text(double value);
/// "(x, y)", "(x, y, z)", "(x, y, z, w)"
std::string tuple_text(const glm::dvec2& v);
std::string tuple_text(const glm::dvec3& v);
std::string tuple_text(const glm::dvec4& v);
std::string tuple_text(const velum::SnappedVertex& v);

/// A negative number in brackets, so that it can stand after an operator: "- (-3)".
std::string operand_text(double value);

/// The six bits, above first: "001000".
std::string bits_text(velum::Outcode code);
/// "001000: outside right", "000000: inside"
std::string outcode_text(velum::Outcode code);
/// "in front, right"; empty for none.
std::string plane_names(velum::Outcode code);

/// "triangle", "segment" or "point"
const char* kind_name(velum::PrimitiveKind kind);
/// `object 0 "house", its triangle 3`
std::string place_text(const velum::Scene& scene, const velum::PrimitivePlace& place);

}  // namespace velum_app
