#include <memory>
#include <velum/shading/texture_rows.hpp>

#include "kernels.hpp"
#include "subject.hpp"

namespace velum_bench {
namespace {

using namespace velum;

/// White, so that a row's colours stay what they are, however often they are multiplied with it.
Material white_texture() {
  constexpr int side = 512;
  Image<Rgba8> picture(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) picture.at(x, y) = {255, 255, 255, 255};
  }
  Material material;
  material.texture = std::make_shared<const Texture>(picture.view());
  return material;
}

/// A row of a plane that recedes: two texels a pixel across, eight along.
void fill(SurfaceRow& row) {
  constexpr double texel = 1.0 / 512.0;
  for (std::size_t i = 0; i < row_room; ++i) {
    row.texture_at[0][i] = 0.1 + 2.0 * texel * static_cast<double>(i);
    row.texture_at[1][i] = 0.3 + 0.1 * texel * static_cast<double>(i);
    row.texture_dx[0][i] = 2.0 * texel;
    row.texture_dx[1][i] = 0.1 * texel;
    row.texture_dy[0][i] = 0.0;
    row.texture_dy[1][i] = 8.0 * texel;
    for (auto& channel : row.colour) channel[i] = 1.0f;
    for (auto& barycentric : row.barycentric) barycentric[i] = 0.25f;
  }
}

void by_reference(const Material& material, TextureFilter filter, SurfaceRow& row) {
  for (std::size_t i = 0; i < most_row_pixels; ++i) {
    const TextureLookup lookup{{row.texture_at[0][i], row.texture_at[1][i]},
                               {row.texture_dx[0][i], row.texture_dx[1][i]},
                               {row.texture_dy[0][i], row.texture_dy[1][i]}};
    const glm::vec4 texel = filtered(*material.texture, material.texture_mapping.wrap, filter, lookup);
    for (int c = 0; c < 4; ++c) row.colour[c][i] *= texel[c];
  }
}

void texture_rows(benchmark::State& state, TextureFilter filter, Isa isa) {
  const Material material = white_texture();
  const RowTexture texture = row_texture_of(material, filter);
  const TrianglePlanes planes{};
  const auto row = std::make_unique<SurfaceRow>();
  fill(*row);
  for (auto _ : state) {
    if (isa == Isa::reference) {
      by_reference(material, filter, *row);
    } else {
      texture_row_kernel(isa)({&planes, &texture, 0, most_row_pixels, row.get()});
    }
    benchmark::DoNotOptimize(row->colour[0][0]);
    benchmark::ClobberMemory();
  }
  count_items(state, most_row_pixels);
}

}  // namespace

void register_texture_rows() {
  constexpr struct {
    const char* name;
    TextureFilter filter;
  } filters[] = {{"nearest", TextureFilter::nearest},
                 {"bilinear", TextureFilter::bilinear},
                 {"trilinear", TextureFilter::trilinear}};
  for (const auto& [filter_name, filter] : filters) {
    for (const Isa isa : measured_isas()) {
      const std::string name = std::string("texture_rows/") + filter_name + "/" + name_of(isa);
      benchmark::RegisterBenchmark(name.c_str(), [filter = filter, isa](benchmark::State& state) {
        texture_rows(state, filter, isa);
      });
    }
  }
}

}  // namespace velum_bench
