// How many rays recursive ray tracing casts.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <plots/log_plot.hpp>

#include "claim.hpp"
#include "measure.hpp"

namespace velum_claims {
namespace {

using namespace velum;
using namespace velum_plots;

constexpr int lights = 2;

/// Every surface mirrors and lets light through: only the number of rays is of interest, not their colours.
class Counter {
 public:
  explicit Counter(const Subject& subject)
      : subject_(subject),
        caster_(subject.scene, AcceleratorKind::bvh),
        nudge_(1e-7 * glm::length(caster_.bounds().size())) {
    Numbers numbers{3};
    for (int i = 0; i < lights; ++i) {
      lights_.push_back(caster_.bounds().centre() +
                        glm::length(caster_.bounds().size()) * numbers.on_sphere());
    }
  }

  void trace(const Ray& ray, const Interval& range, int depth) {
    ++rays;
    const SceneHit hit = caster_.first_hit(ray, range, counters_);
    if (!hit.is_hit()) return;
    const glm::dvec3 at = ray.at(hit.t), along = glm::normalize(ray.direction);
    const glm::dvec3 outside = at - along * nudge_, inside = at + along * nudge_;
    for (const glm::dvec3& light : lights_) {
      ++rays;
      caster_.is_blocked({outside, light - outside}, {0.0, 1.0}, counters_);
    }
    if (depth == 0) return;
    const glm::dvec3 normal = normal_of(hit);
    trace({outside, along - normal * (2.0 * glm::dot(along, normal))}, {}, depth - 1);
    trace({inside, along}, {}, depth - 1);
  }

  double rays = 0.0;

 private:
  glm::dvec3 normal_of(const SceneHit& hit) const {
    const glm::uvec3& t = subject_.world.triangles[hit.primitive];
    const auto p = [&](std::uint32_t i) { return glm::dvec3(subject_.world.positions[i]); };
    const glm::dvec3 normal = glm::cross(p(t.y) - p(t.x), p(t.z) - p(t.x));
    const double length = glm::length(normal);
    return length > 0.0 ? normal / length : glm::dvec3(0, 1, 0);
  }

  const Subject& subject_;
  SceneCaster caster_;
  CastCounters counters_;
  std::vector<glm::dvec3> lights_;
  double nudge_;
};

/// Triangles alone: primitives are then numbered as the triangles of `world`.
bool has_only_triangles(const Subject& subject) {
  return subject.scene.primitive_count() == subject.world.triangles.size() &&
         !subject.world.triangles.empty();
}

/// 1 + 2 + 4 + … + 2^depth
double tree_of(int depth) {
  return std::pow(2.0, depth + 1) - 1.0;
}

}  // namespace

Claim claim_number_of_rays(const std::vector<Subject>& subjects, const Effort& effort) {
  constexpr int width = 48, height = 36;
  const int most_depth = effort.is_quick ? 2 : 6;
  Claim claim;
  claim.title = "The number of rays is bounded by w·h·s·(1 + m)·(1 + 2 + 4 + … + 2^d)";
  claim.source =
      "\"Raytracing\", Komplexität: worst case #rays = O(w·h·s·(1+m)·(1+2+4+…+2^d)); the depth d is limited.";
  claim.formula =
      "each hit asks m lights and sends two secondary rays, down to depth d: at most w·h·s·(1+m)·(2^(d+1) - "
      "1)";
  claim.method =
      "A picture of 48×36, s = 1, m = 2 lights; every surface is taken to mirror and to let light through. "
      "Rays that meet nothing ask no light and send nothing on. The bound is a line of slope 1.";
  LogPlot plot{"Rays over the depth of recursion",
               "48×36 pixels, 2 lights",
               "1 + 2 + 4 + … + 2^depth",
               "rays",
               {{"the bound", {}}}};
  for (int d = 0; d <= most_depth; ++d) {
    const double bound = width * height * (1.0 + lights) * tree_of(d);
    plot.series[0].points.push_back({tree_of(d), bound});
  }
  double most_share = 0.0, deepest_share = 0.0;
  for (const Subject& subject : subjects) {
    if (!has_only_triangles(subject)) continue;
    Series series{subject.name, {}};
    const std::vector<ViewRay> rays = camera_rays(camera_of(subject, 4.0 / 3.0), width, height);
    for (int d = 0; d <= most_depth; ++d) {
      Counter counter(subject);
      for (const ViewRay& ray : rays) counter.trace(ray.ray, ray.range, d);
      series.points.push_back({tree_of(d), counter.rays});
      most_share = std::max(most_share, counter.rays / plot.series[0].points[static_cast<std::size_t>(d)].y);
    }
    deepest_share = std::max(deepest_share, series.points.back().y / plot.series[0].points.back().y);
    plot.series.push_back(series);
  }
  claim.figures.push_back(svg_of(plot));
  claim.verdict = most_share <= 1.0 ? Verdict::holds : Verdict::does_not_hold;
  claim.reason = "At most " + fixed_up(100.0 * most_share, 0) + " % of the bound, and at depth " +
                 std::to_string(most_depth) + " at most " + fixed_up(100.0 * deepest_share, 0) +
                 " %: rays that leave the scene end the doubling.";
  return claim;
}

}  // namespace velum_claims
