#include "analytic_view.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "../base/contract.hpp"
#include "../raycast/intersection/ellipsoid_intersection.hpp"

namespace velum {

AnalyticView::AnalyticView(const Scene& scene, std::span<const AnalyticBody> bodies, Cull cull)
    : cull_(cull) {
  VELUM_REQUIRE(bodies.size() == scene.instances().size(), {"bodies", bodies.size()},
                {"instances", scene.instances().size()});
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    placed_.push_back({bodies[i], glm::inverse(scene.instances()[i].world_from_object)});
  }
}

bool AnalyticView::is_wanted(const AnalyticHit& hit) const {
  return cull_ == Cull::none || hit.back_facing == (cull_ == Cull::front);
}

std::optional<AnalyticHit> AnalyticView::first_hit(const ViewRay& view) const {
  std::optional<AnalyticHit> first;
  for (std::uint32_t i = 0; i < placed_.size(); ++i) {
    const glm::dmat4& object_from_world = placed_[i].object_from_world;
    const Ray ray = transformed(object_from_world, view.ray);
    const SurfaceHits hits =
        std::visit([&ray](const auto& body) { return intersect(ray, body); }, placed_[i].body);
    for (int k = 0; k < hits.count; ++k) {
      const SurfaceHit& met = hits.hits[static_cast<std::size_t>(k)];
      // Normals come back by the inverse transpose.
      const glm::dvec3 normal = glm::transpose(glm::dmat3(object_from_world)) * met.normal;
      const AnalyticHit hit{met.t, glm::normalize(normal), i, glm::dot(ray.direction, met.normal) > 0.0};
      if (!view.range.contains(hit.t) || !is_wanted(hit)) continue;
      if (!first || hit.t < first->t) first = hit;
    }
  }
  return first;
}

}  // namespace velum
