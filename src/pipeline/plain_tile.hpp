#pragma once

#include <cstdint>

#include "../shading/plain_rows.hpp"
#include "../visibility/tile_buffer.hpp"

namespace velum {

/// The pixels of a tile, whose colour depends on the primitive's id alone, and where they go.
struct PlainTile {
  const TileBuffer* pixels;  ///< nullptr: all background
  int width;                 ///< of the part that is wanted, from the top left corner
  int height;
  PlainOutput out;
};

/// Writes a tile straight from its blocks: what store_tile() and then shade_plain_rows_reference() write.
/// @return the number of visible pixels
using ShadePlainTile = std::uint64_t (*)(const PlainTile& tile);

/// The version for an instruction set; for `reference` that of the plainest. @pre is_available(isa)
ShadePlainTile plain_tile_kernel(Isa isa);

}  // namespace velum
