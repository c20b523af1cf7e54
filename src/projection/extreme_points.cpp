#include "extreme_points.hpp"

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>

namespace velum {
namespace {

/// A point's shadow, and which point it is.
struct Shadow {
  glm::dvec2 at;
  std::size_t index;
};

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// One half of the hull (Andrew 1979, "Another Efficient Algorithm for Convex Hulls in Two Dimensions").
template <typename Iterator>
void mark_chain(Iterator first, Iterator last, std::vector<std::uint8_t>& is_extreme) {
  std::vector<Shadow> chain;
  for (; first != last; ++first) {
    while (chain.size() >= 2 && turn(chain[chain.size() - 2].at, chain.back().at, first->at) <= 0.0)
      chain.pop_back();
    chain.push_back(*first);
  }
  for (const Shadow& corner : chain) is_extreme[corner.index] = 1;
}

void mark_hull(std::vector<Shadow>& shadows, std::vector<std::uint8_t>& is_extreme) {
  std::sort(shadows.begin(), shadows.end(), [](const Shadow& a, const Shadow& b) {
    return a.at.x < b.at.x ||
           (a.at.x == b.at.x && (a.at.y < b.at.y || (a.at.y == b.at.y && a.index < b.index)));
  });
  mark_chain(shadows.begin(), shadows.end(), is_extreme);
  mark_chain(shadows.rbegin(), shadows.rend(), is_extreme);
}

}  // namespace

std::vector<glm::dvec3> extreme_points(std::span<const glm::dvec3> points, const CameraAxes& axes,
                                       const glm::dvec3& origin) {
  std::vector<std::uint8_t> is_extreme(points.size(), 0);
  std::vector<Shadow> shadows(points.size());
  for (const int axis : {0, 1}) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::dvec3 p = axes.camera_from_world(points[i] - origin);
      shadows[i] = {{p[axis], p.z}, i};
    }
    mark_hull(shadows, is_extreme);
  }
  std::vector<glm::dvec3> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_extreme[i]) result.push_back(points[i]);
  }
  return result;
}

}  // namespace velum
