// What the surface-area heuristic expects, and what comes.
#include <algorithm>
#include <cmath>
#include <limits>
#include <plots/bar_plot.hpp>
#include <velum/raycast/bvh/bvh.hpp>

#include "claim.hpp"
#include "measure.hpp"

namespace velum_claims {
namespace {

using namespace velum;
using namespace velum_plots;

struct Rule {
  const char* name;
  BvhSplit split;
};
constexpr Rule rules[] = {{"median, one axis", BvhSplit::median}, {"median, cyclic", BvhSplit::cyclic_median},
                          {"midpoint", BvhSplit::midpoint},       {"SAH, sweep", BvhSplit::sah_sweep},
                          {"SAH, binned", BvhSplit::sah_binned},  {"agglomerative", BvhSplit::agglomerative}};

struct Costs {
  double expected = 0.0;   ///< by the areas
  double through = 0.0;    ///< measured: lines through everything
  double first_hit = 0.0;  ///< measured: rays that end at the first hit
  double nanoseconds = 0.0;
  double build = 0.0;  ///< seconds
};

/// c_BV for each inner node that a ray goes into, c_P for each triangle; per ray that meets the root.
double cost_of_counters(const CastCounters& counters, const BvhSettings& settings, double rays) {
  // Each inner node asks for the boxes of its two children; one more was asked before the root.
  const double inner = (static_cast<double>(counters.boxes) - static_cast<double>(counters.rays)) / 2.0;
  return (inner * settings.box_cost + static_cast<double>(counters.tests) * settings.triangle_cost) / rays;
}

Costs costs_of(const Triangles& triangles, BvhSplit split, int lines) {
  BvhSettings settings;
  settings.split = split;
  Costs costs;
  std::unique_ptr<Bvh> bvh;
  costs.build = least_time(1, [&] { bvh = std::make_unique<Bvh>(triangles.set(), settings); });
  costs.expected = expected_cost(bvh->tree(), settings);
  std::vector<Ray> rays = random_lines(bvh->bounds(), lines);
  const BvhNode& root = bvh->tree().nodes.at(0);
  std::erase_if(rays, [&](const Ray& ray) {
    return PreparedRay(ray, {0.0, 1.0}, bvh->bounds()).through(root.lower, root.upper).is_empty();
  });
  CastCounters through, first;
  std::vector<RayHit> hits;
  for (const Ray& ray : rays) bvh->all_hits(ray, {0.0, 1.0}, through, hits);
  for (const Ray& ray : rays) bvh->first_hit(ray, {0.0, 1.0}, first);
  const auto n = static_cast<double>(std::max<std::size_t>(rays.size(), 1));
  costs.through = cost_of_counters(through, settings, n);
  costs.first_hit = cost_of_counters(first, settings, n);
  costs.nanoseconds = cost_of(*bvh, rays).nanoseconds;
  return costs;
}

/// What the verdict looks at.
struct Finding {
  double worst_error = 0.0;   ///< of what was expected
  double worst_regret = 0.0;  ///< by how much another rule costs less than the better SAH rule
};

void add_subject(const Subject& subject, const Effort& effort, Claim& claim, Finding& finding) {
  BarPlot plot{"Cost of a ray that meets the scene's box: " + subject.name,
               "c_BV = 1 per inner node, c_P = 1 per triangle; random lines",
               "cost",
               {"expected", "measured, through everything", "measured, first hit"},
               {}};
  Table table(
      {subject.name, "expected", "through everything", "error", "first hit", "ns per first hit", "build, ms"},
      "lrrrrrr");
  double sah = std::numeric_limits<double>::infinity(), other = sah;
  for (const Rule& rule : rules) {
    const Costs c = costs_of(subject.world, rule.split, effort.is_quick ? 500 : 8000);
    const double error = c.through > 0.0 ? c.expected / c.through - 1.0 : 0.0;
    finding.worst_error = std::max(finding.worst_error, std::fabs(error));
    const bool is_sah = rule.split == BvhSplit::sah_sweep || rule.split == BvhSplit::sah_binned;
    double& best = is_sah ? sah : other;
    if (rule.split != BvhSplit::agglomerative) best = std::min(best, c.first_hit);
    plot.lines.push_back({rule.name, {c.expected, c.through, c.first_hit}});
    table.add({rule.name, short_figure(c.expected), short_figure(c.through), fixed(100.0 * error, 1) + " %",
               short_figure(c.first_hit), short_figure(c.nanoseconds), short_figure(c.build * 1e3)});
  }
  finding.worst_regret = std::max(finding.worst_regret, sah / other - 1.0);
  claim.figures.push_back(svg_of(plot));
  claim.tables.push_back(table);
}

}  // namespace

Claim claim_surface_area_heuristic(const std::vector<Subject>& subjects, const Effort& effort) {
  Claim claim;
  claim.title = "The surface-area heuristic foretells the cost, and gives the cheapest hierarchies";
  claim.source =
      "\"Raytracing\": p(A|B) = S_A/S_B for convex bodies, A in B; MacDonald & Booth found that SAH leads to "
      "the hierarchies that perform best.";
  claim.formula = "expected cost = Σ over nodes of S_node/S_root · (c_BV if inner, n·c_P if leaf)";
  claim.method =
      "Random lines that meet the root, all alike. The heuristic knows no end of a ray: it is compared with "
      "lines that "
      "go on through everything; first hits cost less.";
  Finding finding;
  for (const Subject& subject : subjects) {
    if (!subject.world.triangles.empty()) add_subject(subject, effort, claim, finding);
  }
  const bool foretells = finding.worst_error < 0.1, is_cheapest = finding.worst_regret < 0.02;
  claim.verdict = foretells && is_cheapest   ? Verdict::holds
                  : foretells || is_cheapest ? Verdict::in_part
                                             : Verdict::does_not_hold;
  claim.reason = "Of lines through everything, the cost is foretold within " +
                 fixed(100.0 * finding.worst_error, 1) + " %. " +
                 (is_cheapest ? "No median or midpoint rule gives first hits cheaper by more than 2 %."
                              : "In some scene a median or midpoint rule gives first hits cheaper by " +
                                    fixed(100.0 * finding.worst_regret, 0) + " %.");
  return claim;
}

}  // namespace velum_claims
