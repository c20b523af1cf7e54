// velum-bench-kernels: velum's vector kernels one by one, next to the plain loops they are tested against.
#include <benchmark/benchmark.h>

#include "kernels.hpp"

int main(int argc, char** argv) {
  velum_bench::register_transform();
  velum_bench::register_empty_triangles();
  velum_bench::register_set_up();
  velum_bench::register_tile_raster();
  velum_bench::register_plain_rows();
  velum_bench::register_texture_rows();
  velum_bench::register_frame();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
