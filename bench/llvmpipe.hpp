#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "bench_scenes.hpp"

namespace velum_bench {

/// Mesa's software rasterizer through OSMesa, drawing a benchmark scene in one colour with a depth buffer:
/// the peer that is measured beside velum. Its threads come from LP_NUM_THREADS (0: the calling one alone),
/// which must be set before the first one is made.
class Llvmpipe {
 public:
  /// Uploads the scene. @throws std::runtime_error if OSMesa has no context to give
  explicit Llvmpipe(const BenchScene& bench);
  ~Llvmpipe();

  /// Clears, draws, waits until the pixels are in memory.
  void draw();
  /// After draw(): 1 where a surface is seen, row by row from the top.
  std::vector<std::uint8_t> coverage() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace velum_bench
