#include <algorithm>
#include <sstream>

#include "goals.hpp"
#include "ray_measure.hpp"

namespace velum_bench {
namespace {

using Kind = Verdict::Kind;

/// Millions per second.
double rate(const RayRow& row, const Timing& timing) {
  return static_cast<double>(row.count) / timing.median * 1e-3;
}

std::string rate_text(const RayRow& row, const std::optional<Timing>& timing) {
  return timing ? short_figure(rate(row, *timing)) : "–";
}

Verdict on_ratio(const RayRow& row, double wanted) {
  Verdict verdict;
  verdict.what = row.scene + ", rays, " + row.what + ": Embree ROBUST / velum";
  verdict.wanted = "≥ " + tick_label(wanted) + " ×";
  verdict.kind = Kind::fail;
  if (!row.ratio()) {
    verdict.reached = "not measured";
    verdict.note = "no Embree in this build";
    return verdict;
  }
  verdict.reached = short_figure(*row.ratio()) + " ×";
  verdict.note = short_figure(rate(row, row.velum)) + " against " + rate_text(row, row.robust) +
                 " (default: " + rate_text(row, row.embree) +
                 (row.what == "build" ? ") Mtriangles/s" : ") Mrays/s");
  const bool agrees = !row.same || *row.same >= least_same_hits;
  if (!agrees) verdict.note += "; HITS DIFFER: " + fixed(100.0 * *row.same, 3) + " % the same";
  if (*row.ratio() >= wanted && agrees) verdict.kind = Kind::pass;
  return verdict;
}

Verdict on_memory(const RayMemory& memory) {
  const auto per_triangle = [&](std::int64_t bytes) {
    return static_cast<double>(bytes) / static_cast<double>(memory.triangles);
  };
  const double reached = per_triangle(memory.velum);
  const bool has_goal = memory.scene == memory_scene;
  Verdict verdict;
  verdict.what = memory.scene + ", rays: bytes of the structure per triangle";
  verdict.reached = short_figure(reached) + " B";
  if (has_goal) verdict.wanted = "≤ " + tick_label(most_bytes_per_triangle) + " B";
  if (memory.robust > 0) verdict.note = "Embree ROBUST: " + short_figure(per_triangle(memory.robust)) + " B";
  verdict.kind = !has_goal ? Kind::info : reached <= most_bytes_per_triangle ? Kind::pass : Kind::fail;
  return verdict;
}

Verdict on_threads(const ThreadRow& row) {
  Verdict verdict;
  verdict.what = row.scene + ", picture by rays: two threads against one";
  verdict.wanted = "≥ " + tick_label(wanted_ray_speedup) + " ×";
  verdict.reached = short_figure(row.speedup()) + " ×";
  verdict.note = short_figure(row.one.median) + " ms and " + short_figure(row.two.median) + " ms";
  verdict.kind = row.speedup() >= wanted_ray_speedup ? Kind::pass : Kind::fail;
  return verdict;
}

}  // namespace

Table table_of(const std::vector<RayRow>& rows) {
  Table table({"scene", "rays", "count", "velum M/s", "Embree M/s", "ROBUST M/s", "ROBUST / velum", "same"},
              "llrrrrrr");
  for (const RayRow& row : rows) {
    table.add({row.scene, row.what, std::to_string(row.count), rate_text(row, row.velum),
               rate_text(row, row.embree), rate_text(row, row.robust),
               row.ratio() ? short_figure(*row.ratio()) : "–",
               row.same ? fixed(100.0 * *row.same, 3) + " %" : "–"});
  }
  return table;
}

std::string csv_of(const std::vector<RayRow>& rows) {
  std::ostringstream csv;
  csv << "scene,what,count,velum_ms,embree_ms,embree_robust_ms,same\n";
  csv.precision(9);
  for (const RayRow& row : rows) {
    csv << row.scene << ",\"" << row.what << "\"," << row.count << ',' << row.velum.median << ',';
    if (row.embree) csv << row.embree->median;
    csv << ',';
    if (row.robust) csv << row.robust->median;
    csv << ',';
    if (row.same) csv << *row.same;
    csv << '\n';
  }
  return csv.str();
}

std::vector<Verdict> verdicts_on(const RayFigures& figures) {
  std::vector<Verdict> verdicts;
  for (const RayRow& row : figures.rows) {
    const auto goal = std::find_if(ray_goals.begin(), ray_goals.end(),
                                   [&](const RayGoal& candidate) { return candidate.what == row.what; });
    if (goal != ray_goals.end()) verdicts.push_back(on_ratio(row, goal->wanted));
  }
  for (const RayMemory& memory : figures.memory) verdicts.push_back(on_memory(memory));
  for (const ThreadRow& row : figures.threads) verdicts.push_back(on_threads(row));
  const std::vector<Verdict> on_structures = verdicts_on(figures.structures);
  verdicts.insert(verdicts.end(), on_structures.begin(), on_structures.end());
  return verdicts;
}

}  // namespace velum_bench
