// O(n) without a structure, O(log n) with one.
#include <algorithm>
#include <cmath>
#include <plots/log_plot.hpp>

#include "claim.hpp"
#include "measure.hpp"

namespace velum_claims {
namespace {

using namespace velum;
using namespace velum_plots;

/// One structure's costs over n.
struct Growth {
  AcceleratorName name;
  Series steps, times;
  double build_seconds = 0.0;
  bool is_over = false;
};

/// Enough rays for a figure, few enough for brute force.
int rays_for(AcceleratorKind kind, double n) {
  if (kind != AcceleratorKind::brute_force) return 3000;
  return static_cast<int>(std::clamp(2e7 / n, 100.0, 3000.0));
}

void measure(Growth& growth, const Triangles& triangles, double n) {
  std::unique_ptr<Accelerator> structure;
  growth.build_seconds =
      least_time(1, [&] { structure = build_accelerator(growth.name.kind, triangles.set()); });
  const std::vector<Ray> rays = random_lines(structure->bounds(), rays_for(growth.name.kind, n));
  const CostPerRay cost = cost_of(*structure, rays);
  growth.steps.points.push_back({n, cost.steps()});
  growth.times.points.push_back({n, std::max(cost.nanoseconds, 0.1)});
  const bool is_slow = cost.nanoseconds * 1e-9 * static_cast<double>(rays.size()) > 0.7;
  growth.is_over = growth.build_seconds > 0.8 || is_slow;
}

/// By how much the cost grows when n doubles, over the larger half.
double per_doubling(const Series& series) {
  const Point& first = series.points[series.points.size() / 2 - 1];
  const Point& last = series.points.back();
  return (last.y - first.y) / std::log2(last.x / first.x);
}

const Growth& of_kind(const std::vector<Growth>& all, AcceleratorKind kind) {
  return *std::find_if(all.begin(), all.end(), [&](const Growth& g) { return g.name.kind == kind; });
}

LogPlot plot_of(const std::vector<Growth>& all, bool of_time) {
  LogPlot plot{
      of_time ? "Time of a ray over the number of triangles" : "Steps of a ray over the number of triangles",
      "a sphere; random lines; one thread",
      "triangles",
      of_time ? "nanoseconds per ray" : "nodes and triangles per ray",
      {}};
  for (const Growth& growth : all) plot.series.push_back(of_time ? growth.times : growth.steps);
  return plot;
}

}  // namespace

Claim claim_growth(const Effort& effort) {
  std::vector<Growth> all;
  for (const AcceleratorKind kind :
       {AcceleratorKind::brute_force, AcceleratorKind::bvh, AcceleratorKind::kd_tree, AcceleratorKind::grid,
        AcceleratorKind::octree}) {
    for (const AcceleratorName& name : accelerator_names()) {
      if (name.kind == kind) all.push_back({name, {name.name, {}}, {name.name, {}}});
    }
  }
  for (double n = 1e2; n <= (effort.is_quick ? 1.1e3 : 1.1e6); n *= std::sqrt(10.0)) {
    Triangles triangles;
    triangles.add(sphere_of(n));
    const auto count = static_cast<double>(triangles.triangles.size());
    for (Growth& growth : all) {
      if (!growth.is_over || growth.steps.points.size() < 2) measure(growth, triangles, count);
    }
  }
  const Series& brute = of_kind(all, AcceleratorKind::brute_force).steps;
  const Series& bvh = of_kind(all, AcceleratorKind::bvh).steps;
  const Series& times = of_kind(all, AcceleratorKind::bvh).times;
  Claim claim;
  claim.title = "Without a structure a ray costs n, with one log n";
  claim.source =
      "\"Raytracing\": #comp = O(#rays · n), with acceleration structures O(m·s·w·h·log n). \"Acceleration "
      "Structures\": from O(n) to O(log n).";
  claim.formula =
      "T = c·n against T = c·log n. A power law n^e is a straight line of slope e in the plots; "
      "log n bends towards slope 0, and doubling n adds the same number of steps each time.";
  claim.method =
      "First hits of random lines with a sphere of 10² … 10⁶ triangles; a structure stops where "
      "building it or casting takes too long.";
  claim.figures = {svg_of(plot_of(all, false)), svg_of(plot_of(all, true))};
  Table table({"structure", "triangles up to", "exponent of steps", "of time", "steps added per doubling"},
              "lrrrr");
  for (const Growth& g : all) {
    table.add({g.name.name, fixed(g.steps.points.back().x, 0), fixed(g.steps.exponent_of_large(), 2),
               fixed(g.times.exponent_of_large(), 2), short_figure(per_doubling(g.steps))});
  }
  claim.tables.push_back(table);
  const double e_brute = brute.exponent_of_large(), e_bvh = bvh.exponent_of_large();
  const bool is_linear = std::fabs(e_brute - 1.0) < 0.1, is_logarithmic = e_bvh < 0.25;
  claim.verdict = is_linear && is_logarithmic   ? Verdict::holds
                  : is_linear || is_logarithmic ? Verdict::in_part
                                                : Verdict::does_not_hold;
  claim.reason =
      "Over the larger half, brute force grows with exponent " + fixed(e_brute, 2) +
      ", the bounding volume hierarchy with " + fixed(e_bvh, 2) + ": " + short_figure(per_doubling(bvh)) +
      " steps for each doubling; its time with " + fixed(times.exponent_of_large(), 2) +
      ", for a large tree is not in the caches. Grids follow ∛n, the number of cells along a side.";
  return claim;
}

}  // namespace velum_claims
