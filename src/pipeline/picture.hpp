#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "../base/counters.hpp"
#include "../base/rect.hpp"
#include "../image/colour.hpp"
#include "../image/image.hpp"

namespace velum {

/// What render() gives. All images have the size of the picture (or of its crop).
struct Picture {
  Image<Rgba8> colour;             ///< sRGB, straight alpha
  Image<float> depth;              ///< canonical z in [0, 1]; background 1
  Image<float> metric_depth;       ///< along the look vector, world units; background +infinity
  Image<glm::vec3> normal;         ///< world space, on the viewer's side; background 0
  Image<std::uint32_t> object_id;  ///< instance; background 0xFFFFFFFF
  Image<std::uint32_t>
      triangle_id;  ///< primitive id: the triangle's place in the scene; background 0xFFFFFFFF
  Counters counters;

  /// Gives every image this size; the pixels have no meaning yet.
  void resize(int width, int height);
  /// The share of pixels that show a surface, 0…1.
  double coverage() const;
  /// The smallest rectangle around all pixels that show a surface; empty for none.
  Rect bounding_box() const;
};

/// The picture's depth as ZPyramid takes it: r = 1 - z, 1 near … 0 far; background 0. Of the picture's (or
/// its crop's) size; empty if the picture has no depth.
Image<float> reversed_depth_of(const Picture& picture);

/// Caller-owned memory for the outputs; an empty view is an output not wanted. Sizes must be those of the
/// picture (or its crop). Rows that begin at multiples of 64 bytes, as an Image's do, are written fastest.
struct PictureTarget {
  ImageView<Rgba8> colour{};
  ImageView<float> depth{};
  ImageView<float> metric_depth{};
  ImageView<glm::vec3> normal{};
  ImageView<std::uint32_t> object_id{};
  ImageView<std::uint32_t> triangle_id{};

  /// The same outputs for a part of the rows.
  PictureTarget rows(int top, int count) const;
};

}  // namespace velum
