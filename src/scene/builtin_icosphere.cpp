#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <unordered_map>
#include <utility>

#include "../base/elementary.hpp"
#include "../base/floating_point.hpp"
#include "builtin.hpp"
#include "builtin_parameters.hpp"
#include "builtin_polyhedra.hpp"
#include "builtin_surface.hpp"

namespace velum::shapes {
namespace {

constexpr std::uint32_t k_none = std::numeric_limits<std::uint32_t>::max();

/// A triangulation of the unit sphere.
struct Geodesic {
  std::vector<glm::dvec3> directions;
  std::vector<glm::uvec3> triangles;
};

Geodesic from_icosahedron() {
  const Polyhedron icosahedron = unit_icosahedron();
  Geodesic result{icosahedron.corners, {}};
  for (const auto& face : icosahedron.faces) result.triangles.emplace_back(face[0], face[1], face[2]);
  return result;
}

/// Every triangle becomes four; the middles of the edges move out onto the sphere.
Geodesic subdivided(Geodesic coarse) {
  Geodesic fine{std::move(coarse.directions), {}};
  std::unordered_map<std::uint64_t, std::uint32_t> middles;  // by edge: smaller and larger index
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint64_t edge = (static_cast<std::uint64_t>(std::min(a, b)) << 32) | std::max(a, b);
    const auto [entry, is_new] =
        middles.try_emplace(edge, static_cast<std::uint32_t>(fine.directions.size()));
    if (is_new) fine.directions.push_back(glm::normalize(fine.directions[a] + fine.directions[b]));
    return entry->second;
  };
  fine.triangles.reserve(4 * coarse.triangles.size());
  for (const glm::uvec3& t : coarse.triangles) {
    const glm::uvec3 m(middle(t.x, t.y), middle(t.y, t.z), middle(t.z, t.x));
    fine.triangles.insert(fine.triangles.end(), {{t.x, m.x, m.z}, {m.x, t.y, m.y}, {m.z, m.y, t.z}, m});
  }
  return fine;
}

bool is_pole(const glm::dvec3& direction) {
  return direction.x == 0.0 && direction.z == 0.0;
}

/// Longitude, 0 and 1 at the back, and latitude, 0 at the south pole and 1 at the north pole.
glm::dvec2 longitude_latitude(const glm::dvec3& direction) {
  const double y = std::clamp(direction.y, -1.0, 1.0);
  return {0.5 + elementary::atan2(direction.x, direction.z) / (2.0 * pi), 0.5 + elementary::asin(y) / pi};
}

/// Turns the sphere's triangles into a mesh, with vertices doubled where the texture's left and right edge
/// meet.
class Unwrapping {
 public:
  Unwrapping(SurfaceBuilder& builder, const Geodesic& sphere, double radius)
      : builder_(builder), sphere_(sphere), radius_(radius) {
    for (std::vector<std::uint32_t>& side : index_) side.assign(sphere.directions.size(), k_none);
    for (const glm::dvec3& direction : sphere.directions) uv_.push_back(longitude_latitude(direction));
  }

  void add(const glm::uvec3& triangle) {
    double lowest = 2.0, highest = -1.0;
    for (glm::length_t i = 0; i < 3; ++i) {
      if (is_pole(sphere_.directions[triangle[i]])) continue;
      lowest = std::min(lowest, uv_[triangle[i]].x);
      highest = std::max(highest, uv_[triangle[i]].x);
    }
    // A triangle over the seam goes on to the right of 1, where textures repeat.
    const bool is_over_seam = highest - lowest > 0.5;
    glm::uvec3 corners;
    for (glm::length_t i = 0; i < 3; ++i) {
      const std::uint32_t v = triangle[i];
      if (is_pole(sphere_.directions[v])) {
        const double middle = 0.5 * (lowest + highest + (is_over_seam ? 1.0 : 0.0));
        corners[i] = vertex(v, middle);
      } else {
        corners[i] = shared(v, is_over_seam && uv_[v].x < 0.5);
      }
    }
    builder_.triangle(corners.x, corners.y, corners.z);
  }

 private:
  std::uint32_t vertex(std::uint32_t v, double u) {
    return builder_.vertex({sphere_.directions[v] * radius_, sphere_.directions[v], {u, uv_[v].y}});
  }
  std::uint32_t shared(std::uint32_t v, bool is_beyond_seam) {
    std::uint32_t& index = index_[is_beyond_seam ? 1 : 0][v];
    if (index == k_none) index = vertex(v, uv_[v].x + (is_beyond_seam ? 1.0 : 0.0));
    return index;
  }

  SurfaceBuilder& builder_;
  const Geodesic& sphere_;
  double radius_;
  std::vector<glm::dvec2> uv_;
  std::vector<std::uint32_t> index_[2];  ///< of each direction's vertex: as it is, and one turn further
};

}  // namespace

Mesh icosphere(float radius, int subdivisions) {
  const FloatingPointScope floating_point;
  require_length("icosphere", "radius", radius);
  require_count("icosphere", "subdivisions", subdivisions, 0, 9);
  Geodesic sphere = from_icosahedron();
  for (int i = 0; i < subdivisions; ++i) sphere = subdivided(std::move(sphere));
  SurfaceBuilder builder;
  Unwrapping unwrapping(builder, sphere, radius);
  for (const glm::uvec3& triangle : sphere.triangles) unwrapping.add(triangle);
  return builder.finish("icosphere");
}

}  // namespace velum::shapes
