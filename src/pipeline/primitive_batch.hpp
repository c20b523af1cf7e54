#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "../visibility/sample_positions.hpp"
#include "../visibility/tile_bins.hpp"
#include "geometry_kernels.hpp"
#include "stages.hpp"

namespace velum {

/// An instance's vertices.
struct PlacedVertices {
  glm::dmat4 clip_from_object;
  const PlacedVertex* placed;
  const float* nearness;  ///< see TransformWork
  ClipVertices clip;      ///< only where the mesh has segments or points: the others' are formed when needed
};

/// Neighbouring primitives of one instance, all of one kind.
struct PrimitiveRun {
  std::uint32_t instance = 0;
  PrimitiveKind kind = PrimitiveKind::triangle;
  std::uint32_t vertices = 0;  ///< which of the PlacedVertices
  std::uint32_t first = 0;     ///< primitives first … last-1 among those of the kind
  std::uint32_t last = 0;

  std::uint32_t count() const { return last - first; }
};

/// What one worker sets up and sorts into tiles in one go.
struct PrimitiveBatch {
  std::vector<PrimitiveRun> runs;
  std::uint32_t count = 0;       ///< of primitives in the runs
  ScreenPrimitives primitives;   ///< out
  std::vector<SetUpWork> works;  ///< out: what sets up its small triangles when they are drawn, run by run
  TileBins bins;                 ///< out: of the primitives
  Counters counters;             ///< out: of these primitives

  void clear() {
    runs.clear();
    count = 0;
  }
};

/// What setting up needs to know of the frame.
struct BatchInput {
  const Scene& scene;
  const RenderSettings& settings;
  const TileGrid& grid;
  SetUpTriangles set_up;
  SmallSource::SetUp set_up_small;
  SamplePosition sample = pixel_centre;
};

/// Memory of a worker.
struct BatchScratch {
  KeptArray<std::uint32_t> slow;  ///< triangles that take the plain path
  std::vector<ScreenTriangle> screen_triangles;

  /// Makes as much room as the other has. @pre between two batches: what is in the arrays may get lost
  void make_room_like(const BatchScratch& other);
};

/// Triangles of one instance that have their vertices in common.
struct TriangleList {
  const std::uint32_t* indices;  ///< three per triangle, of the positions
  std::uint32_t first;           ///< triangles first … last-1 are set up
  std::uint32_t last;
  std::uint32_t first_primitive;    ///< see SetUpWork
  const std::uint32_t* primitives;  ///< see SetUpWork
  const glm::vec3* positions;       ///< object space
  const PlacedVertex* placed;       ///< the same vertices on the picture
  /// Where given, small triangles of lists that are not short wait in out.sources: nothing they are made of
  /// may change before they are drawn. Where not, they are set up at once.
  const float* nearness;  ///< see TransformWork
  const glm::dmat4& clip_from_object;
  bool is_mirrored;

  std::uint32_t count() const { return last - first; }
  /// The id of triangle i.
  std::uint32_t primitive(std::uint32_t i) const {
    return first_primitive + (primitives != nullptr ? primitives[i] : i);
  }
};

/// Appends what becomes of the triangles: by the kernel, and by the plain stages where a vertex has no place.
/// Those go to scratch.screen_triangles first, which is emptied.
/// @param work  out: what the kernel was told
void set_up_triangles(const BatchInput& input, const TriangleList& triangles, SetUpWork& work,
                      ScreenPrimitives& out, BatchScratch& scratch, Counters& counters);

/// Fills the batch's bins and counters.
/// @param vertices  of all instances that the runs are of; they stay as they are until the batch is drawn
void set_up_batch(const BatchInput& input, const std::deque<PlacedVertices>& vertices, PrimitiveBatch& batch,
                  BatchScratch& scratch);

/// Translates facing into the signs of the determinant that work's flags are about.
void set_culling(SetUpWork& work, Cull cull, bool mirrored);

}  // namespace velum
