#pragma once

#include <cstdint>
#include <glm/vec4.hpp>

#include "../image/colour.hpp"
#include "../image/image.hpp"
#include "../visibility/fragment_lists.hpp"

namespace velum {

/// What translucent pixels have gathered so far; untouched while everything seen is opaque.
struct LayerBuffers {
  /// A pixel whose colour still lets a further layer through.
  struct OpenPixel {
    std::uint16_t column, row;
  };

  Image<glm::vec4> colour;             ///< linear, premultiplied, front to back
  Image<std::uint8_t> is_translucent;  ///< 1 where the first layer is not opaque
  FragmentLists behind;                ///< what lies behind the first layer

  void clear(int width, int height) {
    colour.resize(width, height, glm::vec4(0.0f));
    is_translucent.resize(width, height, 0);
  }
};

/// Lays a colour (linear, straight alpha) behind what is gathered.
/// @return whether a further layer may still show
bool add_behind(const glm::vec4& colour, glm::vec4& front);

/// What is gathered, laid over a background (linear, straight alpha), in sRGB.
Rgba8 over_background(const glm::vec4& front, const glm::vec4& background);

}  // namespace velum
