#pragma once

#include <cstdint>
#include <vector>

#include "../visibility/sample_positions.hpp"
#include "../visibility/tile_bins.hpp"
#include "geometry_kernels.hpp"
#include "stages.hpp"

namespace velum {

/// A mesh's vertices in clip space and on the picture.
struct PlacedVertices {
  ClipVertices clip;
  std::vector<PlacedVertex> placed;

  void resize(std::size_t count);
};

/// A run of one instance's primitives of one kind: what one worker sets up and sorts into tiles in one go.
struct PrimitiveBatch {
  std::uint32_t instance = 0;
  PrimitiveKind kind = PrimitiveKind::triangle;
  std::uint32_t vertices = 0;  ///< which of the round's PlacedVertices
  std::uint32_t first = 0;     ///< primitives first … last-1 among those of the kind
  std::uint32_t last = 0;
  TileBins bins;                    ///< out
  Counters counters;                ///< out: of these primitives
  std::vector<std::uint32_t> slow;  ///< triangles that take the plain path
};

/// What setting up needs to know of the frame.
struct BatchInput {
  const Scene& scene;
  const RenderSettings& settings;
  const TileGrid& grid;
  SetUpTriangles set_up;
  SamplePosition sample = pixel_centre;
};

/// Fills the batch's bins and counters.
/// @param screen_triangles  scratch memory of the worker
void set_up_batch(const BatchInput& input, const PlacedVertices& vertices, PrimitiveBatch& batch,
                  std::vector<ScreenTriangle>& screen_triangles);

/// Translates facing into the signs of the determinant that work's flags are about.
void set_culling(SetUpWork& work, Cull cull, bool mirrored);

}  // namespace velum
