// Bounding volumes: how tight against how dear.
#include <algorithm>
#include <cmath>
#include <limits>
#include <plots/bar_plot.hpp>
#include <velum/base/error.hpp>
#include <velum/raycast/brute_force/bounded_brute_force.hpp>

#include "claim.hpp"
#include "measure.hpp"

namespace velum_claims {
namespace {

using namespace velum;
using namespace velum_plots;

struct VolumeCost {
  double area = 0.0;         ///< relative to the axis-aligned box
  double hit_rate = 0.0;     ///< of lines that meet the box
  double nanoseconds = 0.0;  ///< of asking the volume, c_BV
};

VolumeCost cost_of(const BoundingVolume& volume, double box_area, const std::vector<PreparedRay>& rays) {
  std::size_t hits = 0;
  const double seconds = least_time(3, [&] {
    hits = 0;
    for (const PreparedRay& ray : rays) hits += !interval_inside(ray, volume).is_empty();
  });
  const auto n = static_cast<double>(std::max<std::size_t>(rays.size(), 1));
  return {volume.area / box_area, static_cast<double>(hits) / n, seconds / n * 1e9};
}

/// Random lines, those that meet the axis-aligned box.
std::vector<PreparedRay> rays_at(const Aabb& box, int count) {
  std::vector<PreparedRay> rays;
  for (const Ray& ray : random_lines(box, count)) {
    const PreparedRay prepared(ray, {0.0, 1.0}, box);
    if (!prepared.through(box.lower, box.upper).is_empty()) rays.push_back(prepared);
  }
  return rays;
}

/// What a ray costs that meets the box, nanoseconds, if the volume holds n triangles.
double expected(const VolumeCost& cost, double n) {
  constexpr double triangle = 20.0;  // c_P, nanoseconds
  return cost.nanoseconds + cost.hit_rate * n * triangle;
}

}  // namespace

Claim claim_bounding_volumes(const std::vector<Subject>& subjects, const Effort& effort) {
  Claim claim;
  claim.title = "k-DOPs are a good compromise between simple and tight bounding volumes";
  claim.source =
      "\"Raytracing\", Hüllvolumen: simple volumes (sphere, ellipsoid, box) are cheap to meet and met often; "
      "tight ones (convex hull) are met "
      "seldom and dear; k-DOPs are a good compromise. And p_BV is proportional to the surface.";
  claim.formula = "T = c_BV + p_BV · n · c_P, with p_BV ∝ surface; here c_P = 20 ns";
  claim.method =
      "Random lines that meet the scene's axis-aligned box. The cost is given for a volume that holds 8 "
      "triangles, as in a "
      "leaf, and for 1000.";
  int best_of_few = 0, best_of_many = 0, scenes = 0;
  double worst = 0.0;
  for (const Subject& subject : subjects) {
    if (subject.world.triangles.size() < 4) continue;
    ++scenes;
    const Aabb box = subject.scene.bounds();
    const std::vector<PreparedRay> rays = rays_at(box, effort.is_quick ? 500 : 30000);
    const double box_area = bounding_volume(VolumeKind::aabb, subject.world.positions).area;
    Table table(
        {subject.name, "surface / box", "hit rate", "c_BV, ns", "T for 8 triangles, ns", "T for 1000, ns"},
        "lrrrrr");
    BarPlot plot{"Bounding volumes: " + subject.name,
                 "share of the lines through the axis-aligned box",
                 "%",
                 {"surface / box", "hit rate"},
                 {}};
    double few = std::numeric_limits<double>::infinity(), many = few;
    bool few_is_dop = false, many_is_dop = false;
    for (const VolumeName& name : volume_names()) {
      BoundingVolume volume;
      try {
        volume = bounding_volume(name.kind, subject.world.positions);
      } catch (const Error&) {
        continue;  // built without a library for convex hulls
      }
      const VolumeCost cost = cost_of(volume, box_area, rays);
      const bool is_dop = name.kind >= VolumeKind::aabb && name.kind <= VolumeKind::dop26;
      if (expected(cost, 8) < few) few_is_dop = is_dop;
      if (expected(cost, 1000) < many) many_is_dop = is_dop;
      few = std::min(few, expected(cost, 8));
      many = std::min(many, expected(cost, 1000));
      if (cost.area <= 1.0) worst = std::max(worst, std::abs(cost.hit_rate - cost.area));
      plot.lines.push_back({name.name, {100.0 * cost.area, 100.0 * cost.hit_rate}});
      table.add({name.name, fixed(cost.area, 3), fixed(cost.hit_rate, 3), short_figure(cost.nanoseconds),
                 short_figure(expected(cost, 8)), short_figure(expected(cost, 1000))});
    }
    best_of_few += few_is_dop;
    best_of_many += many_is_dop;
    claim.figures.push_back(svg_of(plot));
    claim.tables.push_back(table);
  }
  const bool all = best_of_few == scenes && best_of_many == scenes;
  claim.verdict = all                              ? Verdict::holds
                  : best_of_few + best_of_many > 0 ? Verdict::in_part
                                                   : Verdict::does_not_hold;
  claim.reason = "A k-DOP (the box is the 6-DOP) is cheapest in " + std::to_string(best_of_few) + " of " +
                 std::to_string(scenes) + " scenes for 8 triangles, in " + std::to_string(best_of_many) +
                 " for 1000. The hit rate of volumes in the box is their surface's share within " +
                 fixed(100.0 * worst, 1) + " %.";
  return claim;
}

}  // namespace velum_claims
