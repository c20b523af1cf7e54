#pragma once

#include <glm/vec2.hpp>

namespace velum {

/// The exact sign of the area of the triangle a, b, c in the plane: 1 counter-clockwise, -1 clockwise, 0 for
/// points on one line. @pre coordinates are finite
int orientation(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c);

}  // namespace velum
