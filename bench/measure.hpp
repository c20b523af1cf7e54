#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "timing.hpp"
#include "velum_runner.hpp"

namespace velum_bench {

/// What holds for every row.
struct MeasureOptions {
  std::filesystem::path data = "../shared/data";
  VelumOptions velum;
  Patience patience;
  bool has_peer = true;    ///< draw with llvmpipe in turn; ignored where it is not built in
  bool has_memory = true;  ///< run each row once more in a process of its own and look at its memory
};

/// One scene in one mode.
struct Row {
  std::string scene;
  std::string mode;
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;  ///< transformed in a frame
  std::uint64_t left_out = 0;  ///< triangles never transformed, thanks to the octree
  double pixels = 0.0;
  double bytes = 0.0;  ///< the least a plain frame moves: every mesh in once, every output out
  Timing velum;
  std::optional<Timing> llvmpipe;
  std::optional<double> same_coverage;  ///< share of pixels that both, or neither, cover
  std::optional<std::uint64_t> memory;  ///< most of velum's process beyond the scene, bytes

  /// llvmpipe's time / velum's; none without llvmpipe.
  std::optional<double> ratio() const;
  double triangles_per_second() const { return static_cast<double>(triangles) / velum.median * 1e3; }
  double pixels_per_second() const { return pixels / velum.median * 1e3; }
  /// Whether both draw the same scene: pictures that differ say nothing about speed.
  bool agrees() const;
};

/// The share of pixels on whose coverage velum and llvmpipe must agree.
inline constexpr double least_same_coverage = 0.9999;

/// Measures a scene, velum and llvmpipe in turn.
Row measure(const BenchScene& bench, const Mode& mode, const MeasureOptions& options);

/// The most memory that rendering the scene takes beyond it, outputs included, bytes, by running this program
/// again; none if the system does not tell.
std::optional<std::uint64_t> memory_in_child(const std::string& scene, const std::string& mode,
                                             const MeasureOptions& options);
/// That child's part: renders three frames and gives the number. @throws velum::Error as make_scene
std::optional<std::uint64_t> memory_here(const std::string& scene, const std::string& mode,
                                         const MeasureOptions& options);

/// velum's times with one and with two threads, in turn.
struct ThreadRow {
  std::string scene;
  std::string mode;
  Timing one;
  Timing two;
  double speedup() const { return one.median / two.median; }
};
ThreadRow measure_threads(const BenchScene& bench, const Mode& mode, const MeasureOptions& options);

}  // namespace velum_bench
