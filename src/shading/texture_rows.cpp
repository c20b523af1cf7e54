#include "texture_rows.hpp"

#include "../base/elementary.hpp"
#include "texture_filter.hpp"

namespace velum {
namespace {

static_assert(static_cast<int>(TextureWrap::repeat) == 0 && static_cast<int>(TextureWrap::clamp) == 1 &&
              static_cast<int>(TextureWrap::mirror) == 2);
static_assert(static_cast<int>(TextureFilter::nearest) == 0 &&
              static_cast<int>(TextureFilter::bilinear) == 1 &&
              static_cast<int>(TextureFilter::trilinear) == 2);
static_assert(sizeof(glm::vec4) == 4 * sizeof(float));

/// The Gaussian of filtered(), for every number of steps that there can be.
struct ProbeWeights {
  double of[most_probe_steps + 1][most_probe_steps + 1]{};

  ProbeWeights() {
    for (int steps = 1; steps <= most_probe_steps; ++steps) {
      for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        of[steps][i] = elementary::exp(-2.0 * share * share);
      }
    }
  }
};

}  // namespace

RowTexture row_texture_of(const Material& material, TextureFilter filter) {
  static const ProbeWeights weights;
  const Texture& texture = *material.texture;
  const TextureMapping& mapping = material.texture_mapping;
  RowTexture row{};
  row.level_count = texture.level_count();
  for (int i = 0; i < row.level_count; ++i) {
    const Image<glm::vec4>& level = texture.level(i);
    row.levels[i] = {&level.at(0, 0).x, level.stride() * 4, level.width(), level.height()};
  }
  for (int axis = 0; axis < 2; ++axis) {
    row.wrap[axis] = static_cast<int>(mapping.wrap[static_cast<std::size_t>(axis)]);
    row.scale[axis] = static_cast<double>(mapping.scale[axis]);
    row.offset[axis] = static_cast<double>(mapping.offset[axis]);
  }
  row.filter = static_cast<int>(filter);
  row.is_opaque = texture.is_opaque();
  row.weights = weights.of;
  return row;
}

}  // namespace velum
