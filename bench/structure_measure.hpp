#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "measure.hpp"
#include "plots.hpp"
#include "ray_loads.hpp"
#include "verdicts.hpp"

namespace velum_bench {

class EmbreeScene;

/// What a structure costs for one kind of rays: per ray.
struct CastCost {
  double nanoseconds = 0.0;
  double nodes = 0.0;  ///< nodes or cells that a ray goes into
  double tests = 0.0;  ///< triangles that a ray is tested against
};

/// One of velum's structures beside Embree's, single rays, one thread. Reported, not judged: no goal was set.
struct StructureRow {
  std::string scene;
  std::string structure;                        ///< as AcceleratorKind is named, or "Embree ROBUST"
  std::array<std::optional<CastCost>, 3> cast;  ///< by structure_loads
  double build_milliseconds = 0.0;              ///< the only build
  double bytes_per_triangle = 0.0;
};

inline constexpr std::array<std::string_view, 3> structure_loads{"primary, single", "incoherent", "shadow"};
/// The structures of the lectures that are reported, and first the one that they are held against.
inline constexpr std::array<std::string_view, 3> reported_structures{"bvh", "kdtree", "grid"};

/// Measures them in turn on a part of the loads: every sixteenth group of eight rays, since the grid is slow.
/// @param robust  Embree's structure, with RTC_SCENE_FLAG_ROBUST; null: left out
void measure_structures(const BenchScene& bench, const RayLoads& loads, EmbreeScene* robust,
                        const MeasureOptions& options, std::vector<StructureRow>& rows);

Table table_of(const std::vector<StructureRow>& rows);
std::string csv_of(const std::vector<StructureRow>& rows);
/// One line for information per structure that is not the first.
std::vector<Verdict> verdicts_on(const std::vector<StructureRow>& rows);

}  // namespace velum_bench
