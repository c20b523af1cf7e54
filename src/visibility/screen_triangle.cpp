#include "screen_triangle.hpp"

#include "../base/elementary.hpp"

namespace velum {

SnappedVertex snap(const glm::dvec4& vertex, const Viewport& viewport) {
  const glm::dvec2 pixel = viewport.pixel_from_ndc(vertex.x / vertex.w, vertex.y / vertex.w);
  return {static_cast<std::int32_t>(elementary::floor(pixel.x * subpixels + 0.5)),
          static_cast<std::int32_t>(elementary::floor(pixel.y * subpixels + 0.5))};
}

}  // namespace velum
