// Keeping a kd-tree instead of building it again.
#include <algorithm>
#include <limits>
#include <plots/log_plot.hpp>
#include <velum/raycast/kd/kd_file.hpp>

#include "claim.hpp"
#include "measure.hpp"

namespace velum_claims {
namespace {

using namespace velum;
using namespace velum_plots;

double milliseconds(const std::function<void()>& work) {
  return std::max(least_time(3, work) * 1e3, 1e-3);
}

}  // namespace

Claim claim_tree_file(const Effort& effort) {
  Claim claim;
  claim.title = "A kd-tree that was saved is read faster than it is built";
  claim.source =
      "\"Acceleration Structures\": building the kd-tree of a large scene takes long; of a static scene it "
      "is kept, and read "
      "when it is needed. Sampling the cost instead of sorting makes the build cheaper.";
  claim.formula = "reading: O(size of the file); building: O(n log n)";
  claim.method = "Spheres; from bytes in memory, with all checks of the file (a disk adds its own time).";
  KdSettings sampled_settings;
  sampled_settings.samples = 16;
  LogPlot plot{"Time until a kd-tree is ready",
               "one thread",
               "triangles",
               "milliseconds",
               {{"build, exact", {}}, {"build, sampled", {}}, {"read", {}}}};
  Table table({"triangles", "build, ms", "sampled, ms", "read, ms", "times faster", "bytes"}, "rrrrrr");
  double least_gain = std::numeric_limits<double>::infinity();
  for (const double n : effort.is_quick ? std::vector{200.0, 600.0} : std::vector{1e3, 1e4, 1e5}) {
    Triangles triangles;
    triangles.add(sphere_of(n));
    const auto count = static_cast<double>(triangles.triangles.size());
    std::unique_ptr<KdTree> tree;
    const double built = milliseconds([&] { tree = std::make_unique<KdTree>(triangles.set()); });
    const double sampled = milliseconds([&] { KdTree(triangles.set(), sampled_settings); });
    const std::vector<std::byte> bytes = kd_tree_bytes(*tree);
    const double read = milliseconds([&] { kd_tree_from_bytes(bytes, triangles.set(), "memory"); });
    plot.series[0].points.push_back({count, built});
    plot.series[1].points.push_back({count, sampled});
    plot.series[2].points.push_back({count, read});
    table.add({fixed(count, 0), short_figure(built), short_figure(sampled), short_figure(read),
               short_figure(built / read), std::to_string(bytes.size())});
    least_gain = std::min(least_gain, built / read);
  }
  claim.figures.push_back(svg_of(plot));
  claim.tables.push_back(table);
  claim.verdict = least_gain > 1.0 ? Verdict::holds : Verdict::does_not_hold;
  claim.reason = "Reading is at least " + short_figure(least_gain) + " times as fast as building.";
  return claim;
}

}  // namespace velum_claims
