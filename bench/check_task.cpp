#include <algorithm>
#include <cstdio>

#include "goals.hpp"
#include "plots.hpp"
#include "report.hpp"
#include "tasks.hpp"
#include "text_file.hpp"
#include "verdicts.hpp"

namespace velum_bench {
namespace {

bool is_among(const auto& scenes, std::string_view scene) {
  return std::find(scenes.begin(), scenes.end(), scene) != scenes.end();
}

bool has_occlusion_goal(std::string_view scene) {
  return std::any_of(occlusion_goals.begin(), occlusion_goals.end(),
                     [&](const OcclusionGoal& goal) { return goal.scene == scene; });
}

/// Everything that is wanted of one scene, while it is in memory.
void measure_scene(const BenchScene& bench, const Options& options, CheckFigures& figures) {
  figures.frames.push_back(measure(bench, mode_named(default_mode(bench.name)), options.measure));
  if (has_occlusion_goal(bench.name)) {
    figures.depth_only.push_back(measure(bench, mode_named("depth"), options.measure));
  }
  if (is_among(speedup_scenes, bench.name))
    figures.threads.push_back(measure_threads(bench, mode_named("zbuffer"), options.measure));
}

void print_limits(const MachineLimits& limits, const Options& options) {
  Table table({"the machine itself", "one thread", "two threads"}, "lrr");
  const auto add = [&](const char* what, const MachineLimits::Pair& pair, const char* unit) {
    table.add({what, with_prefix(pair.one, unit), with_prefix(pair.two, unit)});
  };
  add("memset of 8 MB", limits.memset_cached, "B/s");
  add("memset of 64 MB", limits.memset_uncached, "B/s");
  add("vertices, bare loop, float32", limits.vertices_float, "/s");
  add("vertices, bare loop, double", limits.vertices_double, "/s");
  print(table, options);
}

}  // namespace

int run_limits(const Options& options) {
  std::printf("%s\n\n", machine_description().c_str());
  print_limits(measure_machine_limits(), options);
  return 0;
}

int run_check(const Options& options) {
  print_circumstances(options);
  CheckFigures figures;
  figures.limits = measure_machine_limits();
  for (const RatioGoal& goal : ratio_goals) {
    std::fprintf(stderr, "  %s …\n", std::string(goal.scene).c_str());
    if (const auto bench = make_scene(std::string(goal.scene), options.measure.data))
      measure_scene(*bench, options, figures);
  }
  std::vector<Row> rows = figures.frames;
  rows.insert(rows.end(), figures.depth_only.begin(), figures.depth_only.end());
  print(table_of(rows), options);
  print_limits(figures.limits, options);
  std::vector<Verdict> verdicts = verdicts_on(figures);
  const RayFigures rays = measure_ray_scenes(options);
  const std::vector<Verdict> on_rays = verdicts_on(rays);
  verdicts.insert(verdicts.end(), on_rays.begin(), on_rays.end());
  print(table_of(rays.rows), options);
  print(table_of(rays.structures), options);
  print(table_of(verdicts), options);
  write_text(options.out / "check.csv", csv_of(rows));
  write_text(options.out / "check.svg", bar_chart_of(figures.frames, circumstances(options)));
  return all_pass(verdicts) ? 0 : 1;
}

}  // namespace velum_bench
