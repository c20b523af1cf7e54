#pragma once

namespace velum_bench {

// Each registers one kernel's benchmarks with Google Benchmark; see register_kernel().

/// Vertices from object space to the picture.
void register_transform();
/// Of clusters of such triangles, which cover no pixel centre.
void register_empty_triangles();
/// Triangles of such vertices: facing, depth plane, what is too small to be seen left out.
void register_set_up();
/// Coverage and depth of such triangles, tile by tile.
void register_tile_raster();
/// Colour and depth of pixels whose triangles are known.
void register_plain_rows();
/// Texels under the pixels of a row.
void register_texture_rows();
/// All stages together, through the public API.
void register_frame();

}  // namespace velum_bench
