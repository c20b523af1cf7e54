#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "raster_triangle.hpp"
#include "screen_triangle.hpp"

namespace velum {

/// Where in a pixel visibility is decided, in 1/256 pixel from its centre, y down.
struct SamplePosition {
  std::int32_t x = 0;
  std::int32_t y = 0;
  bool operator==(const SamplePosition&) const = default;
};

/// What there is without anti-aliasing, and what depth, ids and normals are always those of.
inline constexpr SamplePosition pixel_centre{0, 0};

/// The most samples of a pixel.
inline constexpr int most_samples = 16;

/// Whether there is a pattern of so many samples.
constexpr bool is_sample_count(int count) {
  return count == 1 || count == 4 || count == 8 || count == 16;
}

/// The patterns that hardware shares, in which no two samples lie in one row or column (Microsoft 2009,
/// "Direct3D 11 reference", D3D11_STANDARD_MULTISAMPLE_PATTERN; Khronos 2016, "Vulkan 1.0", §25.3, "Standard
/// sample locations"); 1/16 pixel there, so whole multiples of 16 here.
/// @pre is_sample_count(count)
inline std::span<const SamplePosition> sample_positions(int count) {
  static constexpr std::array<SamplePosition, 1> one{pixel_centre};
  static constexpr std::array<SamplePosition, 4> four{{{-32, -96}, {96, -32}, {-96, 32}, {32, 96}}};
  static constexpr std::array<SamplePosition, 8> eight{
      {{16, -48}, {-16, 48}, {80, 16}, {-48, -80}, {-80, 80}, {-112, -16}, {48, 112}, {112, -112}}};
  static constexpr std::array<SamplePosition, 16> sixteen{{{16, 16},
                                                           {-16, -48},
                                                           {-48, 32},
                                                           {64, -16},
                                                           {-80, -32},
                                                           {32, 80},
                                                           {80, 48},
                                                           {48, -80},
                                                           {-32, 96},
                                                           {0, -112},
                                                           {-64, -96},
                                                           {-96, 64},
                                                           {-128, 0},
                                                           {112, -64},
                                                           {96, 112},
                                                           {-112, -128}}};
  switch (count) {
    case 4:
      return four;
    case 8:
      return eight;
    case 16:
      return sixteen;
    default:
      return one;
  }
}

/// Moves the picture so that a sample comes to lie on the pixel's centre: every raster method then finds what
/// is seen at that sample of every pixel, by the same exact integers and the same float32 expression as at
/// centres. What was in the picture at the sample is at the centre.
inline SnappedVertex seen_from(const SnappedVertex& vertex, const SamplePosition& sample) {
  return {vertex.x - sample.x, vertex.y - sample.y};
}

/// The depth at a sample, in float32 and one written-down order: DepthPlane::at with
///
///   r_ref' = r_ref + (dx·(sample.x / 256) + dy·(sample.y / 256))
///
/// in place of r_ref, so that it is monotone in x and y, in the triangle's range, never -0, and at the centre
/// what it is without samples.
template <typename Plane>
void move_depth(Plane& plane, const SamplePosition& sample) {
  const float along_x = plane.dx * (static_cast<float>(sample.x) / subpixels);
  const float along_y = plane.dy * (static_cast<float>(sample.y) / subpixels);
  plane.r_ref = plane.r_ref + (along_x + along_y);
}

/// A screen triangle as a sample sees it.
inline void move_to(const SamplePosition& sample, ScreenTriangle& triangle) {
  if (sample == pixel_centre) return;
  for (SnappedVertex& vertex : triangle.vertices) vertex = seen_from(vertex, sample);
  move_depth(triangle.depth, sample);
}

/// All of a list. @pre a range of ScreenTriangle
template <typename Triangles>
void move_all_to(const SamplePosition& sample, Triangles& triangles) {
  for (ScreenTriangle& triangle : triangles) move_to(sample, triangle);
}

}  // namespace velum
