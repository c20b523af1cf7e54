#pragma once

#include <cstdint>

#include "../base/rect.hpp"
#include "../image/visibility_buffer.hpp"
#include "depth_format.hpp"
#include "fragment_lists.hpp"

namespace velum {

/// Where a raster method writes.
struct RasterTarget {
  VisibilityBuffer& buffer;
  Rect rect;  ///< the part of the picture that the buffer holds: buffer pixel (0,0) is picture pixel (left,
              ///< top)
  /// Where given, every fragment goes to these lists and nothing to the buffer. Then `rect` is the part of
  /// the picture that the lists expect.
  FragmentLists* lists = nullptr;
  DepthFormat format = DepthFormat::reversed;
};

/// What one call of a raster method did.
struct RasterCounts {
  std::uint64_t zero_area = 0;          ///< triangles without area on the pixel grid
  std::uint64_t pixels_tested = 0;      ///< centres looked at
  std::uint64_t spans = 0;              ///< runs of covered centres (scanline)
  std::uint64_t fragments = 0;          ///< centres covered
  std::uint64_t fragments_written = 0;  ///< fragments nearer than what stood in the buffer
};

}  // namespace velum
