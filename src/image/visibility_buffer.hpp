#pragma once

#include <cstdint>

#include "image.hpp"

namespace velum {

/// The id of the background: no primitive has it. Valid ids are 0 … 0xFFFFFFFE.
inline constexpr std::uint32_t no_primitive = 0xFFFFFFFFu;

/// Which surface is seen at each pixel, and how deep: the answer every visibility method gives, to the same
/// bit.
struct VisibilityBuffer {
  Image<float> reversed_depth;     ///< r = 1 - z: 1 at the near plane, 0 at the far plane; background 0
  Image<std::uint32_t> primitive;  ///< primitive id; background no_primitive

  VisibilityBuffer() = default;
  VisibilityBuffer(int width, int height) { clear(width, height); }

  void clear(int width, int height) {
    reversed_depth.resize(width, height, 0.0f);
    primitive.resize(width, height, no_primitive);
  }
  /// Sets the size; what is in it is anything.
  void reshape(int width, int height) {
    reversed_depth.reshape(width, height);
    primitive.reshape(width, height);
  }
  int width() const { return primitive.width(); }
  int height() const { return primitive.height(); }
};

/// The definition everything rests on: a fragment is seen before another if its (depth, id) is smaller,
/// lexicographically. Reversed depth: nearer is larger.
constexpr bool is_nearer(float r, std::uint32_t id, float other_r, std::uint32_t other_id) {
  return r > other_r || (r == other_r && id < other_id);
}

}  // namespace velum
