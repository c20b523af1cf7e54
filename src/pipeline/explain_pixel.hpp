#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "trace_triangle.hpp"

namespace velum {

/// One edge function at a pixel's centre.
struct EdgeAtCentre {
  SnappedVertex from;
  SnappedVertex to;
  std::int64_t cross = 0;  ///< twice the signed area of (from, to, centre), (1/256 pixel)²
  std::int64_t value = 0;  ///< what the raster tests: ≥ 0 is inside; cross, less one where the edge does not
                           ///< own its points (top-left rule)

  bool owns_its_points() const { return value == cross; }
};

/// Why a fragment is seen, or not.
enum class FragmentOutcome {
  seen,           ///< the largest reversed depth, of equal ones the lowest id
  farther,        ///< a smaller reversed depth than the one seen
  higher_id,      ///< the same depth bits as the one seen, but a higher id
  same_triangle,  ///< the one seen, met again: two pieces of a reversed sliver overlap here
};

/// A piece of a triangle (or one half of a segment's or point's parallelogram) that covers the pixel's
/// centre.
struct CoveringFragment {
  std::uint32_t primitive = 0;
  PrimitivePlace place;
  int piece = 0;   ///< which of the triangle's pieces, from 0
  int pieces = 1;  ///< into how many it was cut; 2 of a segment or point
  /// The piece, its corners in the order in which the raster walks them: clockwise as seen on the picture.
  ScreenTriangle triangle;
  bool is_turned = false;             ///< two corners were swapped for that
  std::array<EdgeAtCentre, 3> edges;  ///< corner 0 → 1, 1 → 2, 2 → 0
  float reversed_depth = 0.0f;        ///< r, to the bit what the visibility buffer gets
  FragmentOutcome outcome = FragmentOutcome::seen;

  /// Canonical depth, as Picture::depth has it.
  float depth() const { return 1.0f - reversed_depth; }
};

/// Why a pixel shows what it shows.
struct PixelExplanation {
  int x = 0;
  int y = 0;
  SnappedVertex centre;                     ///< 1/256 pixel
  std::vector<CoveringFragment> fragments;  ///< nearest first: the order in which depth peeling shows them
  std::optional<TriangleTrace> winner;      ///< the way of the triangle that is seen, if one is
  Counters counters;                        ///< of the geometry stages, for the whole scene
};

/// Collects all fragments at the centre of pixel (x, y) of the whole picture, by the pipeline's own stages
/// and raster, and says who is seen and why. The first fragment's id and depth are those of the rendered
/// picture, to the bit, whatever the method.
/// @param settings  size and culling count; a crop does not
/// @throws Error (usage) for a pixel outside the picture, and as render()
PixelExplanation explain_pixel(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                               int x, int y);

}  // namespace velum
