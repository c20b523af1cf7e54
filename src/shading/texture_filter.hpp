#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "../image/texture.hpp"
#include "../scene/material.hpp"

namespace velum {

/// How the texels under a pixel become one colour.
enum class TextureFilter {
  nearest,    ///< the texel of the picture that holds the pixel's centre
  bilinear,   ///< between the four texels of the picture around the centre
  trilinear,  ///< the mean over the pixel's area, from the pyramid; see filtered()
};

/// What a pixel sees of a texture, in texture coordinates: (0,0) is the picture's lower left corner, (1,1)
/// its upper right one; texel centres lie at +0.5.
struct TextureLookup {
  glm::dvec2 at{0.0};  ///< at the pixel's centre; a coordinate that is not finite counts as 0
  glm::dvec2 dx{0.0};  ///< change per pixel to the right
  glm::dvec2 dy{0.0};  ///< change per pixel down
};

/// The colour of a texture under a pixel, linear with straight alpha; where alpha is 0, black.
///
/// Trilinear: a pixel is an ellipse on the texture, the image of a round Gaussian of standard deviation ½
/// pixel (Heckbert 1989, "Fundamentals of Texture Mapping and Image Warping"; here its axes are the exact
/// singular values of the derivatives). Level of detail is λ = log₂ of a length in texels; a bilinear probe,
/// blended between the levels ⌊λ⌋ and ⌊λ⌋+1 (Williams 1983), is about as wide as a round footprint of that
/// length. λ is taken from the *shorter* axis, and probes with Gaussian weights stand along the longer one,
/// so that a plane towards the horizon is blurred one way only (after McCormack, Perry, Farkas & Jouppi 1999,
/// "Feline: Fast Elliptical Lines for Anisotropic Texture Mapping"; OpenGL 4.6 §8.14 takes λ from the longer
/// axis). At most 49 probes: beyond 16 to 1 the shorter axis is taken as a 16th of the longer one. A picture
/// that is magnified is bilinear.
glm::vec4 filtered(const Texture& texture, const std::array<TextureWrap, 2>& wrap, TextureFilter filter,
                   const TextureLookup& lookup);

}  // namespace velum
