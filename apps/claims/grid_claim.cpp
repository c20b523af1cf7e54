// Grids: their resolution, and the ball in the stadium.
#include <algorithm>
#include <limits>
#include <plots/bar_plot.hpp>
#include <velum/raycast/space/grid.hpp>

#include "claim.hpp"
#include "measure.hpp"

namespace velum_claims {
namespace {

using namespace velum;
using namespace velum_plots;

constexpr const char* lecture = "\"Raytracing\": ";

/// A ball of so many triangles in a stadium a thousand times as wide.
Triangles ball_in_stadium(double triangles) {
  Triangles all;
  all.add(sphere_of(triangles), glm::dmat4(glm::dmat3(0.01)));
  all.add(shapes::cylinder(10.0f, 6.0f, 64));
  return all;
}

/// From around the ball towards it.
std::vector<Ray> rays_at_ball(int count) {
  Numbers numbers{9};
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 from = numbers.on_sphere() * 0.05;
    rays.push_back({from, numbers.on_sphere() * 0.008 - from});
  }
  return rays;
}

}  // namespace

Claim claim_nested_grid(const Effort& effort) {
  const Triangles triangles = ball_in_stadium(effort.is_quick ? 500 : 20000);
  const std::vector<Ray> rays = rays_at_ball(effort.is_quick ? 50 : 500);
  const Grid uniform(triangles.set()), nested(triangles.set(), GridSettings{1.0, 4, 16});
  const CostPerRay one = cost_of(uniform, rays), many = cost_of(nested, rays);
  Claim claim;
  claim.title = "A uniform grid does not adapt to a ball in a stadium; nested grids do";
  claim.source =
      std::string(lecture) +
      "the grid's resolution cannot fit both the ball and the stadium; nested grids are the remedy.";
  claim.formula = "A ball whose size is 1/1000 of the stadium's lies in one cell, unless n > 1000³/27.";
  claim.method =
      "A ball of many triangles, radius 0.01, in a stadium of radius 10; rays from nearby towards the ball.";
  BarPlot plot{"The ball in the stadium", "first hits", "per ray", {"cells", "triangle tests"}, {}};
  plot.lines = {{"uniform grid", {one.nodes, one.tests}}, {"nested grids", {many.nodes, many.tests}}};
  claim.figures.push_back(svg_of(plot));
  const double ratio = one.tests / std::max(many.tests, 1e-9);
  claim.verdict = ratio > 3.0 ? Verdict::holds : Verdict::does_not_hold;
  claim.reason = "The uniform grid tests " + short_figure(one.tests) + " triangles per ray, nested grids " +
                 short_figure(many.tests) + ": " + short_figure(ratio) + " times fewer.";
  return claim;
}

Claim claim_grid_resolution(const std::vector<Subject>& subjects, const Effort& effort) {
  Claim claim;
  claim.title = "A good resolution of a grid is 3·∛n cells along a side";
  claim.source = std::string(lecture) + "resolution: often 3·∛n.";
  claim.formula = "cells along a side = f · ∛n; cost of a ray = cells visited + triangles tested";
  claim.method = "Random lines; f from 0.75 to 6.";
  double worst = 1.0;
  for (const Subject& subject : subjects) {
    if (subject.world.triangles.empty()) continue;
    BarPlot plot{"Grid resolution: " + subject.name,
                 "random lines, first hits",
                 "per ray",
                 {"cells + triangle tests"},
                 {}};
    double least = std::numeric_limits<double>::infinity(), at_three = 0.0;
    for (const double factor : {0.75, 1.5, 3.0, 4.5, 6.0}) {
      const Grid grid(subject.world.set(), GridSettings{factor, 1, 16});
      const CostPerRay cost = cost_of(grid, random_lines(grid.bounds(), effort.is_quick ? 100 : 2000), 1);
      plot.lines.push_back({fixed(factor, 2) + " ∛n", {cost.steps()}});
      least = std::min(least, cost.steps());
      if (factor == 3.0) at_three = cost.steps();
    }
    if (least > 0.0) worst = std::max(worst, at_three / least);
    claim.figures.push_back(svg_of(plot));
  }
  claim.verdict = worst < 1.1 ? Verdict::holds : worst < 1.5 ? Verdict::in_part : Verdict::does_not_hold;
  claim.reason =
      "At 3·∛n a ray costs at most " + fixed_up(worst, 2) +
      " times what it costs at the cheapest resolution of a scene; within 1.1 the claim holds, within 1.5 "
      "in part.";
  return claim;
}

}  // namespace velum_claims
