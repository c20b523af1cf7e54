// Scenes that move: what a frame costs to build and to trace.
#include <algorithm>
#include <functional>
#include <limits>
#include <plots/bar_plot.hpp>
#include <velum/raycast/bvh/bvh.hpp>
#include <velum/raycast/bvh/bvh_refit.hpp>
#include <velum/raycast/kd/kd_tree.hpp>
#include <velum/raycast/space/grid.hpp>

#include "claim.hpp"
#include "measure.hpp"

namespace velum_claims {
namespace {

using namespace velum;
using namespace velum_plots;

using Structure = std::unique_ptr<Accelerator>;

/// A way to come from one frame to the next: called with each frame's triangles in turn.
struct Strategy {
  std::string name;
  std::function<Structure(const TriangleSet&)> next;
};

std::function<Structure(const TriangleSet&)> rebuilt(BvhSplit split) {
  BvhSettings settings;
  settings.split = split;
  return [settings](const TriangleSet& triangles) { return std::make_unique<Bvh>(triangles, settings); };
}

std::function<Structure(const TriangleSet&)> followed(double most_growth) {
  const auto moving = std::make_shared<MovingBvh>(BvhSettings{}, most_growth);
  return [moving](const TriangleSet& triangles) {
    moving->update(triangles);
    return std::make_unique<Bvh>(triangles, moving->tree());
  };
}

std::vector<Strategy> strategies() {
  return {{"bvh: SAH, binned, each frame", rebuilt(BvhSplit::sah_binned)},
          {"bvh: median, each frame", rebuilt(BvhSplit::cyclic_median)},
          {"bvh: refitted", followed(std::numeric_limits<double>::infinity())},
          {"bvh: refitted, built anew at 1.3", followed(1.3)},
          {"kdtree, each frame", [](const TriangleSet& t) { return std::make_unique<KdTree>(t); }},
          {"grid, each frame", [](const TriangleSet& t) { return std::make_unique<Grid>(t); }}};
}

/// A torus that is wrung about its axis, more and more.
/// @param turns  radians per unit of length, in the last frame
std::vector<Triangles> wrung_torus(int frames, int segments, double turns) {
  Triangles rest;
  rest.add(shapes::torus(0.75f, 0.25f, 2 * segments, segments));
  std::vector<Triangles> all(static_cast<std::size_t>(frames), rest);
  for (int frame = 0; frame < frames; ++frame) {
    const double turn = turns * frame / frames;
    for (glm::vec3& p : all[static_cast<std::size_t>(frame)].positions) {
      const glm::dvec3 q(p);
      const double angle = turn * (q.x + q.y + 4.0 * q.y * q.z);
      const double c = elementary::cos(angle), s = elementary::sin(angle);
      p = glm::vec3(c * q.x - s * q.z, q.y, s * q.x + c * q.z);
    }
  }
  return all;
}

struct FrameCost {
  double build = 0.0, trace = 0.0;  ///< milliseconds per frame
  double steps = 0.0;               ///< per ray, last frame
  double sum() const { return build + trace; }
};

FrameCost cost_of_frames(const Strategy& strategy, const std::vector<Triangles>& frames, int rays) {
  FrameCost cost;
  for (const Triangles& frame : frames) {
    Structure structure;
    cost.build += least_time(1, [&] { structure = strategy.next(frame.set()); });
    const CostPerRay per_ray = cost_of(*structure, random_lines(structure->bounds(), rays), 1);
    cost.trace += per_ray.nanoseconds * 1e-9 * rays;
    cost.steps = per_ray.steps();
  }
  const double to_ms = 1e3 / static_cast<double>(frames.size());
  return {cost.build * to_ms, cost.trace * to_ms, cost.steps};
}

struct Winner {
  std::string name;
  double best_bvh = std::numeric_limits<double>::infinity();
  double best_other = std::numeric_limits<double>::infinity();
};

/// Figure and table of one motion.
Winner add_motion(const std::string& motion, const std::vector<Triangles>& frames, int rays, Claim& claim) {
  BarPlot plot{"Milliseconds per frame: wrung " + motion,
               "one thread, processor time",
               "ms",
               {"build or refit", "trace", "sum"},
               {}};
  Table table({"wrung " + motion, "build, ms", "trace, ms", "sum, ms", "steps per ray, last frame"}, "lrrrr");
  Winner winner;
  for (const Strategy& strategy : strategies()) {
    const FrameCost cost = cost_of_frames(strategy, frames, rays);
    if (cost.sum() < std::min(winner.best_bvh, winner.best_other)) winner.name = strategy.name;
    double& best = strategy.name.starts_with("bvh") ? winner.best_bvh : winner.best_other;
    best = std::min(best, cost.sum());
    plot.lines.push_back({strategy.name, {cost.build, cost.trace, cost.sum()}});
    table.add({strategy.name, short_figure(cost.build), short_figure(cost.trace), short_figure(cost.sum()),
               short_figure(cost.steps)});
  }
  claim.figures.push_back(svg_of(plot));
  claim.tables.push_back(table);
  return winner;
}

}  // namespace

Claim claim_moving_scenes(const Effort& effort) {
  const int rays = effort.is_quick ? 300 : 20000, segments = effort.is_quick ? 12 : 72;
  Claim claim;
  claim.title = "Of moving scenes build + trace counts, and a bounding volume hierarchy serves them best";
  claim.source =
      "\"Acceleration Structures\": building and tracing must be balanced so that a frame takes the least "
      "time; kd-trees are built "
      "anew; the best for dynamic scenes is the BVH.";
  claim.formula = "time of a frame = build or refit + trace";
  claim.method = "A torus of " + std::to_string(4 * segments * segments) +
                 " triangles is wrung over some frames, a little and a lot; " + std::to_string(rays) +
                 " random lines a frame. Differences within 5 % count as none: times vary by as much.";
  constexpr double tolerance = 1.05;
  int held = 0, motions = 0;
  for (const auto& [name, turns] : {std::pair{"a little", 0.5}, std::pair{"a lot", 5.0}}) {
    const std::vector<Triangles> frames = wrung_torus(effort.is_quick ? 3 : 16, segments, turns);
    const Winner winner = add_motion(name, frames, rays, claim);
    held += winner.best_bvh <= tolerance * winner.best_other ? 1 : 0;
    ++motions;
    claim.reason += std::string(claim.reason.empty() ? "" : " ") + "Wrung " + name + ": best hierarchy " +
                    short_figure(winner.best_bvh) + " ms a frame, best other structure " +
                    short_figure(winner.best_other) + " ms; least: " + winner.name + ".";
  }
  claim.verdict = held == motions ? Verdict::holds : held > 0 ? Verdict::in_part : Verdict::does_not_hold;
  return claim;
}

}  // namespace velum_claims
