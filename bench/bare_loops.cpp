#include "bare_loops.hpp"

// The function once per instruction set, chosen when the program starts.
#if defined(__x86_64__) && defined(__linux__)
#define VELUM_BENCH_WIDEST __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define VELUM_BENCH_WIDEST
#endif

namespace velum_bench {
namespace {

template <typename T>
[[gnu::always_inline]] inline void transform(VertexBlock<T>& __restrict block, const T* __restrict m) {
  for (std::size_t i = 0; i < block.count; ++i) {
    const T x = block.x[i], y = block.y[i], z = block.z[i];
    const T w = m[3] * x + m[7] * y + m[11] * z + m[15];
    const T one_over_w = T(1) / w;
    block.x_out[i] = (m[0] * x + m[4] * y + m[8] * z + m[12]) * one_over_w;
    block.y_out[i] = (m[1] * x + m[5] * y + m[9] * z + m[13]) * one_over_w;
    block.z_out[i] = (m[2] * x + m[6] * y + m[10] * z + m[14]) * one_over_w;
    block.w_out[i] = w;
  }
}

}  // namespace

VELUM_BENCH_WIDEST void transform_block(VertexBlock<float>& block, const float* matrix) {
  transform(block, matrix);
}
VELUM_BENCH_WIDEST void transform_block(VertexBlock<double>& block, const double* matrix) {
  transform(block, matrix);
}

}  // namespace velum_bench
