#include <velum/shading/plain_rows.hpp>
#include <velum/visibility/zbuffer.hpp>

#include "kernels.hpp"
#include "subject.hpp"

namespace velum_bench {
namespace {

using namespace velum;

void shade_rows(benchmark::State& state, const Subject& subject, Isa isa) {
  const int width = subject.viewport.width, height = subject.viewport.height;
  VisibilityBuffer buffer(width, height);
  rasterize_zbuffer(set_up_by_reference(subject), {.buffer = buffer, .rect = subject.rect()});
  Image<Rgba8> colour(width, height);
  Image<float> depth(width, height);
  const PlainRows rows{width,
                       height,
                       buffer.primitive.row(0),
                       buffer.primitive.stride(),
                       buffer.reversed_depth.row(0),
                       buffer.reversed_depth.stride(),
                       {reinterpret_cast<std::uint8_t*>(colour.row(0)),
                        colour.stride(),
                        depth.row(0),
                        depth.stride(),
                        nullptr,
                        0,
                        {0, 0, 0, 0},
                        true}};
  const ShadePlainRows shade = plain_rows_kernel(isa);
  for (auto _ : state) {
    benchmark::DoNotOptimize(shade(rows));
    benchmark::ClobberMemory();
  }
  count_items(state, static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

}  // namespace

void register_plain_rows() {
  register_kernel("plain_rows", shade_rows);
}

}  // namespace velum_bench
