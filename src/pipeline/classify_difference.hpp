#pragma once

#include <cstdint>

#include "../projection/viewing_transform.hpp"
#include "../projection/viewport.hpp"
#include "../scene/scene.hpp"
#include "settings.hpp"

namespace velum {

/// Why a pixel of two answers to "which surface is seen?", one by the raster and one by rays, may show
/// different triangles.
enum class Agreement : std::uint8_t {
  same,         ///< it does not
  edge,         ///< its centre is as near to an edge of one of them as snapping can move that edge
  cut,          ///< the same for the line where the near or the far plane cuts one of them
  tie,          ///< their depths there are equal within the rounding of float32
  unexplained,  ///< none of these: a fault
};
inline constexpr int agreement_count = 5;

/// How far snapping can move a point on an edge: half of 1/256 pixel in x and in y, and what double loses.
inline constexpr double snapping_reach = 1.4142135623730951 / 512.0 + 1e-6;

/// Explains differences between the triangles that two methods see at pixels. Works in clip space, so that
/// every projection and every embedder's matrix is one case; shares no coverage or depth code with either.
class DifferenceClassifier {
 public:
  DifferenceClassifier(const Scene& scene, const ViewingTransform& viewing, const RenderSettings& settings);

  /// @param x, y         pixel of the whole picture
  /// @param raster, ray  primitive ids, or no_primitive
  Agreement classify(int x, int y, std::uint32_t raster, std::uint32_t ray) const;

 private:
  struct SeenTriangle;
  bool is_triangle(std::uint32_t primitive) const;
  SeenTriangle seen(std::uint32_t primitive) const;

  const Scene& scene_;
  const ViewingTransform& viewing_;
  Viewport viewport_;
};

}  // namespace velum
