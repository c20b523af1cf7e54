#include <algorithm>
#include <sstream>

#include "structure_measure.hpp"

namespace velum_bench {
namespace {

bool is_velum(const StructureRow& row) {
  return std::find(reported_structures.begin(), reported_structures.end(), row.structure) !=
         reported_structures.end();
}

const StructureRow* beside(const std::vector<StructureRow>& rows, const StructureRow& row,
                           std::string_view structure) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const StructureRow& other) {
    return other.scene == row.scene && other.structure == structure;
  });
  return found == rows.end() ? nullptr : &*found;
}

/// One figure per kind of rays, " / " between.
template <typename Figure>
std::string by_load(const StructureRow& row, Figure figure) {
  std::string text;
  for (std::size_t load = 0; load < structure_loads.size(); ++load) {
    if (load > 0) text += " / ";
    text += row.cast[load] ? short_figure(figure(*row.cast[load], load)) : "–";
  }
  return text;
}

double rate(const CastCost& cost) {
  return 1e3 / cost.nanoseconds;
}

/// The other's time / the row's, per kind of rays.
std::string times_of(const StructureRow& other, const StructureRow& row) {
  return by_load(row, [&](const CastCost& cost, std::size_t load) {
    return other.cast[load] ? other.cast[load]->nanoseconds / cost.nanoseconds : 0.0;
  });
}

std::string nodes_and_tests(const StructureRow& row) {
  return by_load(row, [](const CastCost& cost, std::size_t) { return cost.nodes; }) + " nodes and " +
         by_load(row, [](const CastCost& cost, std::size_t) { return cost.tests; }) + " triangles per ray";
}

}  // namespace

Table table_of(const std::vector<StructureRow>& rows) {
  Table table({"scene", "structure", "rays, single", "M/s", "nodes per ray", "triangles per ray", "build ms",
               "bytes per triangle"},
              "lllrrrrr");
  for (const StructureRow& row : rows) {
    for (std::size_t load = 0; load < structure_loads.size(); ++load) {
      if (!row.cast[load]) continue;
      const CastCost& cost = *row.cast[load];
      table.add({row.scene, row.structure, std::string(structure_loads[load]), short_figure(rate(cost)),
                 is_velum(row) ? short_figure(cost.nodes) : "–",
                 is_velum(row) ? short_figure(cost.tests) : "–", short_figure(row.build_milliseconds),
                 short_figure(row.bytes_per_triangle)});
    }
  }
  return table;
}

std::string csv_of(const std::vector<StructureRow>& rows) {
  std::ostringstream csv;
  csv << "scene,structure,rays,nanoseconds_per_ray,nodes_per_ray,triangles_per_ray,build_ms,bytes_per_"
         "triangle\n";
  csv.precision(9);
  for (const StructureRow& row : rows) {
    for (std::size_t load = 0; load < structure_loads.size(); ++load) {
      if (!row.cast[load]) continue;
      const CastCost& cost = *row.cast[load];
      csv << row.scene << ',' << row.structure << ",\"" << structure_loads[load] << "\"," << cost.nanoseconds
          << ',';
      if (is_velum(row))
        csv << cost.nodes << ',' << cost.tests;
      else
        csv << ',';
      csv << ',' << row.build_milliseconds << ',' << row.bytes_per_triangle << '\n';
    }
  }
  return csv.str();
}

std::vector<Verdict> verdicts_on(const std::vector<StructureRow>& rows) {
  std::vector<Verdict> verdicts;
  for (const StructureRow& row : rows) {
    if (!is_velum(row) || row.structure == reported_structures.front()) continue;
    Verdict verdict;
    verdict.what = row.scene + ", rays, " + row.structure + ": primary / incoherent / shadow, single";
    verdict.reached = by_load(row, [](const CastCost& cost, std::size_t) { return rate(cost); }) + " Mrays/s";
    verdict.note = "built in " + short_figure(row.build_milliseconds) + " ms, " +
                   short_figure(row.bytes_per_triangle) + " B per triangle; " + nodes_and_tests(row);
    if (const StructureRow* bvh = beside(rows, row, reported_structures.front()))
      verdict.note += " (bvh: " + nodes_and_tests(*bvh) + ")";
    if (const StructureRow* robust = beside(rows, row, "Embree ROBUST"))
      verdict.note += "; Embree ROBUST / velum " + times_of(*robust, row);
    verdicts.push_back(verdict);
  }
  return verdicts;
}

}  // namespace velum_bench
