#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "../base/executor.hpp"
#include "../visibility/draw_tile.hpp"
#include "primitive_batch.hpp"

namespace velum {

/// What the stage keeps between frames.
struct TileStageBuffers {
  /// Memory of one worker.
  struct Worker {
    BatchScratch scratch;
    KeptArray<TilePrimitives> work;  ///< what meets the tile, batch by batch
    TileOrder order;
    TileBuffer tile;
    TileCounts counts;
  };

  std::deque<PlacedVertices> vertices;  ///< of the instances that wait to be drawn
  KeptArray<PlacedVertex> placed;       ///< theirs, one after the other
  KeptArray<float> nearness;            ///< the same
  std::vector<PrimitiveBatch> batches;  ///< the first `used` of them are the round's
  std::size_t used = 0;
  std::vector<Worker> workers;
};

/// Takes the pixels of a finished tile.
/// @param pixels  nullptr if nothing is seen there
/// @param tile    in the picture
using TileSink = std::function<void(const TileBuffer* pixels, const Rect& tile, int worker)>;

/// What the stage needs to know of the frame.
struct TileStageInput {
  const Scene& scene;
  const ViewingTransform& viewing;
  const RenderSettings& settings;
  Rect rect;
  Executor& executor;
  /// Told the share of the scene that is drawn, 0…1, after each round, on the calling thread.
  const std::function<void(double)>& progress;
  SamplePosition sample = pixel_centre;  ///< where in the pixels visibility is decided
  /// Where given, finished tiles go there while they are in cache, and what the buffer holds afterwards is
  /// nobody's concern.
  const TileSink* sink = nullptr;
  Rect within = rect;  ///< instances that lie beside this are left out; holds `rect`
};

/// Bytes that the stage takes, as a rule: the vertices of a wave of instances, and the primitives of a round.
/// What each worker has, and what is told of large triangles tile by tile, comes on top.
std::uint64_t tile_stage_bytes(const Scene& scene);

/// The production z-buffer: primitives are transformed, set up and sorted into tiles, wave by wave; when they
/// are many, or all, each tile draws its primitives while it stays in cache (sort-middle: Molnar, Cox,
/// Ellsworth & Fuchs 1994, "A Sorting Classification of Parallel Rendering"). Each step runs on all threads;
/// since the smaller (depth, id) wins in any order, the buffer is rasterize_zbuffer's to the bit.
/// @param buffer  is given rect's size
void draw_in_tiles(const TileStageInput& input, TileStageBuffers& buffers, VisibilityBuffer& buffer,
                   Counters& counters);

}  // namespace velum
