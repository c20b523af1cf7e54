// What structures spare.
#include <algorithm>
#include <plots/bar_plot.hpp>

#include "claim.hpp"
#include "measure.hpp"

namespace velum_claims {
namespace {

using namespace velum;
using namespace velum_plots;

/// The picture's rays, those that end after the far plane too.
std::vector<Ray> rays_of(const Subject& subject, const Effort& effort) {
  std::vector<Ray> rays;
  const int width = effort.is_quick ? 24 : 96;
  for (const ViewRay& view : camera_rays(camera_of(subject, 4.0 / 3.0), width, width * 3 / 4))
    rays.push_back(view.ray);
  return rays;
}

}  // namespace

Claim claim_structures(const std::vector<Subject>& subjects, const Effort& effort) {
  Claim claim;
  claim.title = "A structure spares nearly all intersections";
  claim.source =
      "\"Interactive Computer Graphics\" 11: the goal is to reduce the number of ray/primitive "
      "intersections.";
  claim.formula = "share spared = 1 - (tests per ray) / n";
  claim.method =
      "First hits of a camera's rays; all triangles of the scene in one structure with its usual settings.";
  double least_spared = 1.0;
  for (const Subject& subject : subjects) {
    const std::vector<Ray> rays = rays_of(subject, effort);
    const auto n = static_cast<double>(subject.world.triangles.size());
    if (n < 1.0) continue;
    Table table({subject.name + ", " + short_figure(n) + " triangles", "nodes per ray", "box tests",
                 "triangle tests", "spared", "ns per ray", "build, ms", "bytes per triangle"},
                "lrrrrrrr");
    BarPlot plot{"Nodes and intersections per ray: " + subject.name,
                 "a camera's rays",
                 "per ray",
                 {"nodes or cells", "triangle tests"},
                 {}};
    for (const AcceleratorName& name : accelerator_names()) {
      if (name.kind == AcceleratorKind::brute_force) continue;
      std::unique_ptr<Accelerator> structure;
      const double build =
          least_time(1, [&] { structure = build_accelerator(name.kind, subject.world.set()); });
      const CostPerRay cost = cost_of(*structure, rays);
      const double spared = 1.0 - cost.tests / n;
      least_spared = std::min(least_spared, spared);
      table.add({name.name, short_figure(cost.nodes), short_figure(cost.boxes), short_figure(cost.tests),
                 fixed(100.0 * spared, 2) + " %", short_figure(cost.nanoseconds), short_figure(build * 1e3),
                 short_figure(static_cast<double>(structure->memory()) / n)});
      plot.lines.push_back({name.name, {cost.nodes, cost.tests}});
    }
    claim.figures.push_back(svg_of(plot));
    claim.tables.push_back(table);
  }
  claim.verdict = least_spared > 0.9 ? Verdict::holds : Verdict::in_part;
  claim.reason =
      "Every structure spares at least " + fixed_down(100.0 * least_spared, 2) + " % of the intersections.";
  return claim;
}

}  // namespace velum_claims
