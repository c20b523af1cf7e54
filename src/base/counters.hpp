#pragma once

#include <cstdint>

#include "hierarchy_counters.hpp"

namespace velum {

/// What happened while a picture was made. Deterministic for given settings, whatever the thread count.
/// Units: things counted (no times).
struct Counters {
  std::uint64_t instances = 0;         ///< drawn
  std::uint64_t instances_beside = 0;  ///< left out, with all they have: their boxes lie beside the crop
  std::uint64_t vertices = 0;          ///< vertices transformed, counted once per instance
  std::uint64_t triangles = 0;         ///< triangles that entered the pipeline
  std::uint64_t segments = 0;          ///< segments that entered the pipeline
  std::uint64_t segments_clipped = 0;  ///< cut by at least one plane, something left
  std::uint64_t segments_outside = 0;  ///< nothing of it inside the view volume
  std::uint64_t points = 0;            ///< points that entered the pipeline
  std::uint64_t points_outside = 0;    ///< not inside the view volume
  std::uint64_t not_finite = 0;   ///< primitives skipped: a vertex is NaN or infinite after the transform
  std::uint64_t back_facing = 0;  ///< of the not rejected: those that face away (removed only when culled)
  std::uint64_t edge_on = 0;      ///< homogeneous determinant exactly 0: count as front-facing
  std::uint64_t culled = 0;       ///< removed by the facing test
  std::uint64_t trivially_accepted = 0;  ///< nothing to cut: no vertex outside the view volume or guard band
  std::uint64_t trivially_rejected = 0;  ///< AND of the outcodes is not 0
  std::uint64_t clipped = 0;             ///< cut by at least one plane, something left
  std::uint64_t clipped_away = 0;        ///< neither accepted nor rejected, but nothing left
  std::uint64_t at_eye = 0;              ///< dropped: a corner is the centre of projection itself (w = 0)
  std::uint64_t outside[6] = {};         ///< triangles wholly outside plane i (bit i of the outcode)
  std::uint64_t cut_by[6] = {};          ///< triangles cut by plane i
  std::uint64_t screen_triangles = 0;    ///< pieces that reached the raster; two for a segment or point
  std::uint64_t zero_area = 0;           ///< pieces without area on the pixel grid
  std::uint64_t reversed = 0;            ///< slivers that snapping turned over
  // What one method does and another does not; 0 where it is not counted.
  std::uint64_t hidden_triangles = 0;  ///< vector z-buffer: left out of a tile, behind all that stands there
  std::uint64_t hidden_blocks = 0;     ///< vector z-buffer: 8×8 blocks of larger triangles left out likewise
  std::uint64_t drawn_blocks = 0;      ///< vector z-buffer: 8×8 blocks of larger triangles looked at
  std::uint64_t pixels_tested = 0;     ///< centres looked at: plain z-buffer: in boxes; scanline: in spans
  std::uint64_t spans = 0;             ///< scanline: runs of covered centres on a row
  std::uint64_t fragments = 0;  ///< plain z-buffer, scanline: centres covered, compared with the buffer
  std::uint64_t fragments_written = 0;  ///< plain z-buffer, scanline: nearer than what the buffer held
  std::uint64_t rays = 0;               ///< raycast: one per pixel
  std::uint64_t ray_nodes = 0;          ///< raycast: nodes or cells that the rays went into
  std::uint64_t ray_boxes = 0;          ///< raycast: intersections with boxes or dividing planes
  std::uint64_t ray_tests = 0;          ///< raycast: intersections with triangles
  HierarchyCounters hierarchy{};        ///< hierarchical method: what it left out, and where

  std::uint64_t pixels_shaded = 0;  ///< visible fragments shaded: one per pixel and layer

  std::uint64_t layers = 0;  ///< depth peeling: layers shaded until nothing shone through

  /// Sums everything up; of the layers, the most.
  Counters& operator+=(const Counters& other);

  /// Those alone that count pixels, not primitives: of the parts of a picture they add up to the whole's.
  Counters of_pixels() const;

  /// The share of triangles removed because they face away, 0…1; 0 for no triangles.
  double culled_share() const {
    return triangles == 0 ? 0.0 : static_cast<double>(culled) / static_cast<double>(triangles);
  }
};

}  // namespace velum
