#pragma once

#include "../base/rect.hpp"
#include "../image/visibility_buffer.hpp"
#include "tile_buffer.hpp"

namespace velum {

/// Fetches the pixels of `rect` (of the whole picture) from the buffer that holds `target`.
/// @param left, top  the tile's first pixel in the picture
void load_tile(const VisibilityBuffer& buffer, const Rect& target, int left, int top, TileBuffer& tile);

/// A tile where nothing has been drawn yet.
void clear_tile(const Rect& target, int left, int top, TileBuffer& tile);

/// Puts the tile's pixels that lie in `target` back.
void store_tile(const TileBuffer& tile, const Rect& target, int left, int top, VisibilityBuffer& buffer);

}  // namespace velum
