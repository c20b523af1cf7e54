#pragma once

#include <cstddef>

namespace velum_bench {

/// A block of vertices, each coordinate by itself.
template <typename T>
struct VertexBlock {
  static constexpr std::size_t count = 512;
  T x[count], y[count], z[count];
  T x_out[count], y_out[count], z_out[count], w_out[count];
};

/// Multiplies a block by a matrix (16, column by column) and divides by w: the least a rasterizer does to a
/// vertex, with nothing around it, in the widest instructions of this machine.
void transform_block(VertexBlock<float>& block, const float* matrix);
void transform_block(VertexBlock<double>& block, const double* matrix);

}  // namespace velum_bench
