#pragma once

/// Rows of a picture whose colour depends on the primitive's id alone: what Shading::triangle_id shows, or no
/// colour at all.

#include <cstddef>
#include <cstdint>

#include "../base/isa.hpp"

namespace velum {

/// Where a rectangle of pixels goes. Each plane has its own pointer to the first row's first pixel and its
/// own stride, in elements; nullptr: not wanted.
struct PlainOutput {
  std::uint8_t* colour;  ///< red, green, blue, alpha per pixel, sRGB
  std::ptrdiff_t colour_stride;
  float* depth;  ///< canonical, 1 - reversed depth
  std::ptrdiff_t depth_stride;
  std::uint32_t* ids;
  std::ptrdiff_t ids_stride;
  std::uint8_t background[4];
  bool is_large;  ///< the picture is larger than the caches: better written past them
};

/// A rectangle of pixels and where it goes.
struct PlainRows {
  int width;
  int height;
  const std::uint32_t* ids;  ///< background: no_primitive
  std::ptrdiff_t ids_stride;
  const float* reversed_depth;  ///< background: 0
  std::ptrdiff_t reversed_depth_stride;
  PlainOutput out;
};

/// Writes what is wanted: each visible pixel has the colour id_colour() of its primitive.
/// @return the number of visible pixels
using ShadePlainRows = std::uint64_t (*)(const PlainRows& rows);

/// The textbook loop; the vector versions give the same bytes.
std::uint64_t shade_plain_rows_reference(const PlainRows& rows);

/// The version for an instruction set. @pre is_available(isa)
ShadePlainRows plain_rows_kernel(Isa isa);

}  // namespace velum
