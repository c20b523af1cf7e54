#pragma once

#include <span>

#include "near_first.hpp"
#include "tile_raster.hpp"

namespace velum {

/// What meets a tile in the order in which it is drawn.
struct TileOrder {
  NearFirst<LargeInTile> large;
  NearFirst<SmallInTile> small;

  /// Makes as much room as the other has.
  void make_room_like(const TileOrder& other);
};

/// Draws all that meets a tile, in the order that hides most: large triangles before small ones, both from
/// near to far. The picture is the same in any order.
/// @param work       all of it, in as many parts as there are
/// @param left, top  the tile's first pixel in the picture
void draw_tile(const TileRaster& raster, std::span<const TilePrimitives> work, int left, int top,
               TileOrder& order, TileBuffer& tile, TileCounts& counts);

}  // namespace velum
