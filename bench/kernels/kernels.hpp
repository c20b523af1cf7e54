#pragma once

namespace velum_bench {

// Each registers one kernel's benchmarks with Google Benchmark; see register_kernel().

/// Vertices from object space to the picture.
void register_transform();
/// Colour and depth of pixels whose triangles are known.
void register_plain_rows();
/// All stages together, through the public API.
void register_frame();

}  // namespace velum_bench
