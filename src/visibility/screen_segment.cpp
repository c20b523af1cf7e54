#include "screen_segment.hpp"

#include <utility>

namespace velum {
namespace {

/// A width on both sides of a centre, in 1/256 pixel. The two sum to the width; they differ by one unit where
/// it is odd.
struct Extent {
  std::int32_t before;
  std::int32_t after;
};

Extent extent_of(float width) {
  const auto whole = static_cast<std::int32_t>(static_cast<double>(width) * subpixels + 0.5);
  return {whole / 2, whole - whole / 2};
}

/// Corners in order around a parallelogram; its two halves share a diagonal, so each centre is in one.
void append_quad(const std::array<SnappedVertex, 4>& corners, const ScreenTriangle& prototype,
                 std::vector<ScreenTriangle>& out) {
  ScreenTriangle half = prototype;
  half.vertices = {corners[0], corners[1], corners[2]};
  out.push_back(half);
  half.vertices = {corners[0], corners[2], corners[3]};
  out.push_back(half);
}

}  // namespace

void append_segment(const SnappedVertex& a, const SnappedVertex& b, float width,
                    const ScreenTriangle& prototype, std::vector<ScreenTriangle>& out) {
  const Extent extent = extent_of(width);
  const bool x_major = is_x_major(a, b);
  // From left to right, or from top to bottom, so that the direction does not matter.
  const bool is_backwards = x_major ? b.x < a.x : b.y < a.y;
  const SnappedVertex& first = is_backwards ? b : a;
  const SnappedVertex& last = is_backwards ? a : b;
  if (x_major) {
    append_quad({{{first.x, first.y - extent.before},
                  {last.x, last.y - extent.before},
                  {last.x, last.y + extent.after},
                  {first.x, first.y + extent.after}}},
                prototype, out);
  } else {
    append_quad({{{first.x - extent.before, first.y},
                  {first.x + extent.after, first.y},
                  {last.x + extent.after, last.y},
                  {last.x - extent.before, last.y}}},
                prototype, out);
  }
}

void append_point(const SnappedVertex& centre, float size, const ScreenTriangle& prototype,
                  std::vector<ScreenTriangle>& out) {
  const Extent extent = extent_of(size);
  append_quad({{{centre.x - extent.before, centre.y - extent.before},
                {centre.x + extent.after, centre.y - extent.before},
                {centre.x + extent.after, centre.y + extent.after},
                {centre.x - extent.before, centre.y + extent.after}}},
              prototype, out);
}

}  // namespace velum
