#pragma once

/// The arithmetic of a pixel whose samples see different things: linear light, float32, one written-down
/// order.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "../image/colour.hpp"

namespace velum {

/// The bits 0 … count-1: every sample of a pixel.
constexpr std::uint32_t all_samples(int count) {
  return (1u << count) - 1u;
}

/// Where a primitive is shaded that is seen at some of a pixel's samples: at their centroid, which lies in
/// the primitive because it is convex; at the pixel's centre if it is seen at all of them (as Direct3D's
/// centroid sampling, and because the patterns' own centroid need not be the centre).
/// @param samples  bit k: sample k; not 0
/// @param count    samples per pixel
/// @return from the pixel's centre, in pixels, y down
glm::dvec2 centroid_of(std::uint32_t samples, int count);

/// Puts a further layer behind what is in front (Porter & Duff 1984, "Compositing digital images").
/// @param front   linear, premultiplied
/// @param colour  linear, straight alpha
glm::vec4 with_behind(const glm::vec4& front, const glm::vec4& colour);

/// The mean of the samples' colours as a picture shows them. Each is first clamped to what can be shown
/// (colour to 0 … alpha, alpha to 0 … 1), so that a highlight beyond white does not make its edge hard; then
/// they are summed in pairs, which gives exactly the sample if all are equal.
/// @param samples  linear, premultiplied; used up
/// @param count    a power of two
/// @return sRGB, straight alpha
Rgba8 resolved(glm::vec4* samples, int count);

}  // namespace velum
