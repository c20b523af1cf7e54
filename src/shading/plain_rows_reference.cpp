#include <cstring>

#include "../image/colour.hpp"
#include "../image/visibility_buffer.hpp"
#include "plain_rows.hpp"
#include "shading.hpp"

namespace velum {

std::uint64_t shade_plain_rows_reference(const PlainRows& rows) {
  const PlainOutput& out = rows.out;
  std::uint64_t visible = 0;
  for (std::ptrdiff_t y = 0; y < rows.height; ++y) {
    for (std::ptrdiff_t x = 0; x < rows.width; ++x) {
      const std::uint32_t id = rows.ids[y * rows.ids_stride + x];
      visible += id != no_primitive;
      if (out.depth != nullptr) {
        const float r = rows.reversed_depth[y * rows.reversed_depth_stride + x];
        out.depth[y * out.depth_stride + x] = 1.0f - r;
      }
      if (out.ids != nullptr) out.ids[y * out.ids_stride + x] = id;
      if (out.colour == nullptr) continue;
      std::uint8_t* const pixel = out.colour + 4 * (y * out.colour_stride + x);
      if (id == no_primitive) {
        std::memcpy(pixel, out.background, 4);
      } else {
        const Rgba8 colour = srgb_from_linear(id_colour(id));
        pixel[0] = colour.r, pixel[1] = colour.g, pixel[2] = colour.b, pixel[3] = colour.a;
      }
    }
  }
  return visible;
}

}  // namespace velum
