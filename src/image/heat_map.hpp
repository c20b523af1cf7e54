#pragma once

#include <glm/vec3.hpp>

#include "colour.hpp"
#include "image.hpp"

namespace velum {

/// Where two pictures of one size differ, and how much: equal pixels show the first picture, grey and dim;
/// different ones glow from dark red (the smallest difference) over yellow to white (the largest there can
/// be, 255 codes). The channel that differs most counts, alpha too. Opaque.
/// @throws Error (usage) when the sizes differ
Image<Rgba8> heat_map(ImageView<const Rgba8> a, ImageView<const Rgba8> b);

/// For floats: black where equal; white is the largest finite difference of the two pictures, and any that is
/// not finite.
Image<Rgba8> heat_map(ImageView<const float> a, ImageView<const float> b);
Image<Rgba8> heat_map(ImageView<const glm::vec3> a, ImageView<const glm::vec3> b);

}  // namespace velum
