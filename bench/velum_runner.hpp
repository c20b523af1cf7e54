#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>
#include <velum/velum.hpp>

#include "scenes.hpp"

namespace velum_bench {

/// What velum is asked for in a frame.
struct Mode {
  std::string name;
  velum::VisibilityMethod method = velum::VisibilityMethod::zbuffer;
  bool colour = true;  ///< without: depth (and ids) alone, nothing is shaded
  bool ids = false;    ///< the primitive ids, too

  /// Bytes of its outputs per pixel.
  int bytes_per_pixel() const { return 4 + (colour ? 4 : 0) + (ids ? 4 : 0); }
};

/// The modes by name: zbuffer and hierarchical give colour and depth, ids these and the ids, depth only the
/// depth; scanline and raycast are there to compare.
std::vector<Mode> modes();
/// @pre the name is one of modes()
Mode mode_named(const std::string& name);
/// The mode a scene is measured in unless another is asked for: hierarchical for thousands of instances.
std::string default_mode(const std::string& scene);

/// How velum runs; the same for all modes.
struct VelumOptions {
  velum::Shading shading = velum::Shading::triangle_id;
  velum::Isa isa = velum::Isa::best;
  int threads = 1;
};

/// velum with its outputs, drawing one scene again and again.
class VelumRunner {
 public:
  /// @param bench  outlives the runner
  VelumRunner(const BenchScene& bench, const Mode& mode, const VelumOptions& options);

  void draw();
  /// 1 where a surface is seen, row by row from the top. Draws a frame of its own.
  std::vector<std::uint8_t> coverage();
  /// Of the last frame.
  const velum::Counters& counters() const { return counters_; }

 private:
  const BenchScene& bench_;
  velum::Renderer renderer_;
  velum::RenderSettings settings_;
  velum::Image<velum::Rgba8> colour_;
  velum::Image<float> depth_;
  velum::Image<std::uint32_t> ids_;
  velum::PictureTarget target_;
  velum::Counters counters_;
};

}  // namespace velum_bench
