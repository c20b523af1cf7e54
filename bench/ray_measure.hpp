#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "measure.hpp"
#include "plots.hpp"
#include "structure_measure.hpp"
#include "verdicts.hpp"

namespace velum_bench {

/// One way of casting one kind of rays at one scene, or building the structure. Times are milliseconds.
struct RayRow {
  std::string scene;
  std::string what;       ///< "primary, packets", "primary, single", "incoherent", "shadow", "build"
  std::size_t count = 0;  ///< rays, or triangles
  Timing velum;
  std::optional<Timing> embree;  ///< default settings
  std::optional<Timing> robust;  ///< RTC_SCENE_FLAG_ROBUST: the one that counts
  std::optional<double> same;    ///< share of rays that hit the same triangle as with ROBUST (shadow: any)

  /// ROBUST's time / velum's.
  std::optional<double> ratio() const;
};

/// A structure's size.
struct RayMemory {
  std::string scene;
  std::size_t triangles = 0;
  std::int64_t velum = 0;
  std::int64_t robust = 0;
};

struct RayFigures {
  std::vector<RayRow> rows;
  std::vector<RayMemory> memory;
  std::vector<StructureRow> structures;
  std::vector<ThreadRow> threads;  ///< pictures by ray casting
};

/// The scenes of one mesh that rays are cast at.
inline constexpr std::array<std::string_view, 4> ray_scenes{"bunny", "castle", "sponza", "bunny16"};

/// Measures everything on one of them, velum and Embree in turn, one thread each.
void measure_rays(const BenchScene& bench, const MeasureOptions& options, RayFigures& figures);

Table table_of(const std::vector<RayRow>& rows);
std::string csv_of(const std::vector<RayRow>& rows);
/// One verdict per goal that was measured.
std::vector<Verdict> verdicts_on(const RayFigures& figures);

}  // namespace velum_bench
