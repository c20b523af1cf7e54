#include "verdicts.hpp"

#include <algorithm>

#include "goals.hpp"

namespace velum_bench {
namespace {

using Kind = Verdict::Kind;

template <typename Rows>
const typename Rows::value_type* row_of(const Rows& rows, std::string_view scene) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.scene == scene; });
  return found == rows.end() ? nullptr : &*found;
}

Verdict not_measured(Verdict verdict, const std::string& why) {
  verdict.kind = Kind::fail;
  verdict.reached = "not measured";
  verdict.note = why;
  return verdict;
}

Kind kind_of(bool is_reached) {
  return is_reached ? Kind::pass : Kind::fail;
}

std::string times(double value) {
  return short_figure(value) + " ×";
}
std::string milliseconds(double value) {
  return short_figure(value) + " ms";
}

Verdict on_ratio(const RatioGoal& goal, const std::vector<Row>& rows) {
  Verdict verdict;
  verdict.what = std::string(goal.scene) + ": llvmpipe / velum, one core each";
  verdict.wanted = "≥ " + tick_label(goal.wanted) + " ×";
  verdict.hoped = tick_label(goal.hoped) + " ×";
  const Row* row = row_of(rows, goal.scene);
  if (row == nullptr) return not_measured(verdict, "its files are not there");
  if (!row->ratio()) return not_measured(verdict, "no llvmpipe in this build");
  verdict.reached = times(*row->ratio());
  verdict.note =
      row->mode + ": " + milliseconds(row->velum.median) + " against " + milliseconds(row->llvmpipe->median);
  if (!row->agrees()) verdict.note += "; COVERAGE DIFFERS: " + fixed(100.0 * *row->same_coverage, 4) + " %";
  verdict.kind = kind_of(*row->ratio() >= goal.wanted && row->agrees());
  return verdict;
}

Verdict on_threads(std::string_view scene, const std::vector<ThreadRow>& rows) {
  Verdict verdict;
  verdict.what = std::string(scene) + ": two threads against one";
  verdict.wanted = "≥ " + tick_label(wanted_speedup) + " ×";
  const ThreadRow* row = row_of(rows, scene);
  if (row == nullptr) return not_measured(verdict, "its files are not there");
  verdict.reached = times(row->speedup());
  verdict.note = milliseconds(row->one.median) + " and " + milliseconds(row->two.median);
  verdict.kind = kind_of(row->speedup() >= wanted_speedup);
  return verdict;
}

Verdict on_memory(const std::vector<Row>& rows) {
  Verdict verdict;
  verdict.what = std::string(memory_scene) + ": memory beyond the scene";
  verdict.wanted = "≤ " + fixed(most_memory / 1e6, 0) + " MB";
  const Row* row = row_of(rows, memory_scene);
  if (row == nullptr) return not_measured(verdict, "its files are not there");
  if (!row->memory) return not_measured(verdict, "the system does not tell");
  const auto bytes = static_cast<double>(*row->memory);
  verdict.reached = fixed(bytes / 1e6, 0) + " MB";
  verdict.note = "most resident of a process of its own, outputs included";
  verdict.kind = kind_of(bytes <= most_memory);
  return verdict;
}

/// Scales their published time by llvmpipe's here and there; see OcclusionGoal.
Verdict on_depth_only(const OcclusionGoal& goal, const std::vector<Row>& rows) {
  Verdict verdict;
  verdict.what = std::string(goal.scene) + ": depth only / MaskedOcclusionCulling";
  verdict.wanted = "≤ " + tick_label(goal.wanted) + " ×";
  const Row* row = row_of(rows, goal.scene);
  if (row == nullptr) return not_measured(verdict, "its files are not there");
  if (!row->llvmpipe) return not_measured(verdict, "no llvmpipe in this build to scale by");
  const double machine = row->llvmpipe->median / goal.llvmpipe_milliseconds;
  const double theirs = goal.their_milliseconds * machine;
  const double reached = row->velum.median / theirs;
  verdict.reached = times(reached);
  verdict.note = milliseconds(row->velum.median) + " against " + milliseconds(theirs) +
                 ", NOT MEASURED: published " + milliseconds(goal.their_milliseconds) + " × " +
                 short_figure(machine) + " (llvmpipe's depth only here / published)";
  verdict.kind = kind_of(reached <= goal.wanted && row->agrees());
  return verdict;
}

std::string percent(double share) {
  return short_figure(100.0 * share) + " %";
}

/// What the octree spares.
Verdict on_left_out(const Row& row) {
  const double share = static_cast<double>(row.left_out) / static_cast<double>(row.triangles);
  return {Verdict::Kind::info,
          row.scene + ", " + row.mode + ": triangles never transformed",
          percent(share),
          "",
          "",
          ""};
}

/// How near a frame comes to the limits of memory and of arithmetic.
void add_limits(std::vector<Verdict>& verdicts, const Row& row, const MachineLimits& limits) {
  const double seconds = row.velum.median / 1e3;
  const double bytes = row.bytes / seconds, vertices = static_cast<double>(row.vertices) / seconds;
  const std::string name = row.scene + ", " + row.mode + ": ";
  verdicts.push_back({Kind::info, name + "bytes moved at least", with_prefix(bytes, "B/s"), "", "",
                      percent(bytes / limits.memset_uncached.one) + " of memset of 64 MB (" +
                          with_prefix(limits.memset_uncached.one, "B/s") + ")"});
  verdicts.push_back({Kind::info, name + "vertices", with_prefix(vertices, "/s"), "", "",
                      percent(vertices / limits.vertices_double.one) + " of a bare transform loop (" +
                          with_prefix(limits.vertices_double.one, "/s") + " in double)"});
}

}  // namespace

std::vector<Verdict> verdicts_on(const CheckFigures& figures) {
  std::vector<Verdict> verdicts;
  for (const RatioGoal& goal : ratio_goals) verdicts.push_back(on_ratio(goal, figures.frames));
  for (const std::string_view scene : speedup_scenes) verdicts.push_back(on_threads(scene, figures.threads));
  verdicts.push_back(on_memory(figures.frames));
  for (const OcclusionGoal& goal : occlusion_goals)
    verdicts.push_back(on_depth_only(goal, figures.depth_only));
  for (const Row& row : figures.frames) {
    if (row.mode == "hierarchical") verdicts.push_back(on_left_out(row));
    add_limits(verdicts, row, figures.limits);
  }
  return verdicts;
}

bool all_pass(const std::vector<Verdict>& verdicts) {
  return std::none_of(verdicts.begin(), verdicts.end(),
                      [](const Verdict& verdict) { return verdict.kind == Kind::fail; });
}

Table table_of(const std::vector<Verdict>& verdicts) {
  Table table({"", "what", "reached", "wanted", "hoped", "how"}, "llrrrl");
  for (const Verdict& verdict : verdicts) {
    const char* kind = verdict.kind == Kind::pass ? "PASS" : verdict.kind == Kind::fail ? "FAIL" : "info";
    table.add({kind, verdict.what, verdict.reached, verdict.wanted, verdict.hoped, verdict.note});
  }
  return table;
}

}  // namespace velum_bench
