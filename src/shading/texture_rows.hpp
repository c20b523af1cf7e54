#pragma once

/// The vector version of filtered(), over neighbouring pixels of a row: coordinates, gradients and levels of
/// detail of several pixels at once, texels with their channels at once. The results are the same to the bit.

#include <cstddef>

#include "surface_rows.hpp"

namespace velum {

/// One level of a texture as the kernels read it: linear, premultiplied, four channels, row 0 the top.
struct TextureLevel {
  const float* texels;
  std::ptrdiff_t stride;  ///< floats from row to row
  int width;
  int height;
};

/// The probes that filtered() puts along a footprint stand at most so many steps to each side.
inline constexpr int most_probe_steps = 24;

/// A material's texture, its mapping and how it is filtered.
struct RowTexture {
  TextureLevel levels[32];
  int level_count;
  int wrap[2];  ///< TextureWrap as a number
  int filter;   ///< TextureFilter as a number
  double scale[2];
  double offset[2];
  bool is_opaque;
  /// Of the probe i of n: weights[n][i].
  const double (*weights)[most_probe_steps + 1];
};

struct TexturingWork {
  const TrianglePlanes* triangle;
  const RowTexture* texture;
  std::size_t begin;  ///< indices of the row, as in SurfaceWork
  std::size_t end;
  SurfaceRow* row;  ///< texture_at, texture_dx and texture_dy are read; colour is multiplied with the texel
};
using TextureRow = void (*)(const TexturingWork& work);

/// The kernel for an instruction set. @pre is_available(isa), and not `reference`
TextureRow texture_row_kernel(Isa isa);

struct Material;
enum class TextureFilter;

/// @pre the material has a texture, which must outlive the result
RowTexture row_texture_of(const Material& material, TextureFilter filter);

}  // namespace velum
