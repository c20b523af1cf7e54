#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "scenes.hpp"

namespace velum_bench {

/// Whether this program was built with OSMesa.
bool has_llvmpipe();

/// How many threads draw, the calling one included. @pre no Llvmpipe was made yet: Mesa asks only once
void set_llvmpipe_threads(int threads);

/// Mesa's software rasterizer through OSMesa, drawing a benchmark scene in one colour with a depth buffer:
/// the peer that is measured beside velum.
class Llvmpipe {
 public:
  /// Uploads the scene. @param has_colour  false: depth only
  /// @throws std::runtime_error if OSMesa has no context to give, or is not built in
  Llvmpipe(const BenchScene& bench, bool has_colour);
  ~Llvmpipe();
  Llvmpipe(const Llvmpipe&) = delete;
  Llvmpipe& operator=(const Llvmpipe&) = delete;

  /// Clears, draws, waits until the pixels are in memory.
  void draw();
  /// After draw(): 1 where a surface is seen, row by row from the top.
  std::vector<std::uint8_t> coverage() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace velum_bench
