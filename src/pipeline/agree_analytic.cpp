#include "agree_analytic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "../base/contract.hpp"
#include "../base/floating_point.hpp"
#include "../image/visibility_buffer.hpp"
#include "../raycast/camera_rays.hpp"
#include "../raycast/intersection/ellipsoid_intersection.hpp"
#include "check_request.hpp"
#include "render.hpp"
#include "render_analytic.hpp"

namespace velum {
namespace {

/// The distance of a triangle's plane from the centre; of a cap of a cylinder: none.
double distance_of_plane(const AnalyticBody& body, const glm::dvec3& a, const glm::dvec3& normal) {
  if (const auto* sphere = std::get_if<Sphere>(&body)) return std::fabs(glm::dot(normal, a - sphere->centre));
  const auto& cylinder = std::get<Cylinder>(body);
  const glm::dvec3 axis = glm::normalize(cylinder.second - cylinder.first);
  if (std::fabs(glm::dot(normal, axis)) > 0.5) return cylinder.radius;
  return std::fabs(glm::dot(normal, a - cylinder.first));
}

double radius_of(const AnalyticBody& body) {
  return std::visit([](const auto& b) { return b.radius; }, body);
}

/// Of a point from the centre, or from the axis.
double distance_from_middle(const AnalyticBody& body, const glm::dvec3& p) {
  if (const auto* sphere = std::get_if<Sphere>(&body)) return glm::length(p - sphere->centre);
  const auto& cylinder = std::get<Cylinder>(body);
  const glm::dvec3 axis = glm::normalize(cylinder.second - cylinder.first), from = p - cylinder.first;
  return glm::length(from - axis * glm::dot(from, axis));
}

AnalyticBody shrunk(AnalyticBody body, double share) {
  std::visit([share](auto& b) { b.radius *= share; }, body);
  return body;
}

/// Finds out whether rays run between the bodies and what their meshes enclose.
class Silhouettes {
 public:
  Silhouettes(const Scene& scene, std::span<const AnalyticBody> bodies, const CameraRays& rays)
      : rays_(rays) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Instance& instance = scene.instances()[i];
      const double share = inner_share(bodies[i], scene.meshes()[instance.mesh]);
      least_share_ = std::min(least_share_, share);
      placed_.push_back({bodies[i], shrunk(bodies[i], share), glm::inverse(instance.world_from_object)});
    }
  }

  double least_share() const { return least_share_; }

  /// Whether a ray, moved by as much as snapping does, runs between a body and what its mesh encloses.
  bool has(double px, double py) const {
    constexpr double snap = 1.0 / 512.0;
    return std::any_of(placed_.begin(), placed_.end(), [&](const Placed& placed) {
      bool meets = false, misses = false;
      for (const glm::dvec2& by : {glm::dvec2(0.0), glm::dvec2(-snap), glm::dvec2(-snap, snap),
                                   glm::dvec2(snap, -snap), glm::dvec2(snap)}) {
        const ViewRay view = rays_.through(px + by.x, py + by.y);
        meets = meets || is_met(placed.outer, placed, view);
        misses = misses || !is_met(placed.inner, placed, view);
      }
      return meets && misses;
    });
  }

 private:
  /// A body with a place in the world, and the part that its mesh encloses.
  struct Placed {
    AnalyticBody outer, inner;
    glm::dmat4 object_from_world;
  };

  static bool is_met(const AnalyticBody& body, const Placed& placed, const ViewRay& view) {
    const Ray ray = transformed(placed.object_from_world, view.ray);
    return std::visit([&](const auto& b) { return intersect(ray, b).first_in(view.range).has_value(); },
                      body);
  }

  const CameraRays& rays_;
  std::vector<Placed> placed_;
  double least_share_ = 1.0;
};

}  // namespace

double inner_share(const AnalyticBody& body, const Mesh& mesh) {
  const FloatingPointScope floating_point;
  double least = radius_of(body), farthest = 0.0;
  for (const glm::vec3& p : mesh.positions) {
    farthest = std::max(farthest, distance_from_middle(body, glm::dvec3(p)));
  }
  VELUM_REQUIRE(std::fabs(farthest - radius_of(body)) <= 1e-6 * radius_of(body),
                {"farthest vertex", farthest}, {"radius", radius_of(body)});
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    if (length > 0.0) least = std::min(least, distance_of_plane(body, a, normal / length));
  }
  constexpr double rounding = 1.0 - 0x1.0p-20;  // of the vertices, which are floats
  return least / radius_of(body) * rounding;
}

AnalyticAgreement agree_analytic(const Scene& scene, std::span<const AnalyticBody> bodies,
                                 const Camera& camera, const RenderSettings& settings) {
  const FloatingPointScope floating_point;
  RenderSettings ids = settings;
  ids.shading = Shading::object_id;
  const Picture rays = render_analytic(scene, bodies, camera, ids);
  const Picture raster = render(scene, camera, ids);
  const Rect rect = requested_rect(settings);
  const CameraRays camera_rays(requested_view(camera, settings), {settings.width, settings.height});
  const Silhouettes silhouettes(scene, bodies, camera_rays);
  AnalyticAgreement result;
  result.inner_share = silhouettes.least_share();
  for (int y = 0; y < rect.height; ++y) {
    for (int x = 0; x < rect.width; ++x) {
      const std::uint32_t by_raster = raster.object_id.at(x, y), by_ray = rays.object_id.at(x, y);
      ++result.pixels;
      result.covered += by_raster != no_primitive || by_ray != no_primitive;
      if (by_raster == by_ray) continue;
      const bool is_explained = silhouettes.has(rect.left + x + 0.5, rect.top + y + 0.5);
      ++(is_explained ? result.silhouette : result.unexplained);
    }
  }
  return result;
}

}  // namespace velum
