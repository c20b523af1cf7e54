#include <algorithm>

#include "../visibility/screen_triangle.hpp"
#include "empty_triangles.hpp"
#include "empty_triangles_window.hpp"

namespace velum {
namespace {

struct Corner {
  std::int32_t x, y;
};

/// Twice the area of the triangle p, q and the origin.
std::int32_t cross(const Corner& p, const Corner& q) {
  return p.x * q.y - p.y * q.x;
}

/// One coordinate of three corners: the pixels first … last have their centres between the outermost.
struct Centres {
  std::int32_t first, last;
  Centres(std::int32_t a, std::int32_t b, std::int32_t c)
      : first((std::min({a, b, c}) + subpixels / 2 - 1) >> subpixel_bits),
        last((std::max({a, b, c}) - subpixels / 2) >> subpixel_bits) {}
};

void count(const EmptyTrianglesWork& work, std::int32_t area, Counters& counters) {
  const bool is_culled = (area < 0 && work.cull_positive) || (area > 0 && work.cull_negative);
  ++counters.triangles;
  counters.culled += is_culled;
  counters.trivially_accepted += !is_culled;
  counters.screen_triangles += !is_culled;
  counters.zero_area += area == 0;
  counters.back_facing += work.is_back_positive ? area < 0 : area > 0;
}

}  // namespace

std::uint32_t leave_out_empty_reference(const EmptyTrianglesWork& work, Counters& counters) {
  PlacedBox box;
  for (std::uint32_t i = 0; i < work.vertex_count; ++i) box.include(work.placed[work.first_vertex + i]);
  const PlacedWindow window = work.vertex_count > most_packed_vertices ? PlacedWindow{} : window_around(box);
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < work.triangle_count; ++i) {
    const std::uint32_t* const index = work.indices + 3 * static_cast<std::size_t>(i);
    if (window.is_narrow) {
      const auto corner = [&](int v) {
        return Corner{work.placed[index[v]].x - window.left, work.placed[index[v]].y - window.top};
      };
      const Corner a = corner(0), b = corner(1), c = corner(2);
      const Centres columns(a.x, b.x, c.x), rows(a.y, b.y, c.y);
      const Corner centre{columns.first * subpixels + subpixels / 2, rows.first * subpixels + subpixels / 2};
      const auto seen_from_centre = [&](const Corner& v) { return Corner{v.x - centre.x, v.y - centre.y}; };
      const Corner p = seen_from_centre(a), q = seen_from_centre(b), r = seen_from_centre(c);
      const std::int32_t edges[3] = {cross(p, q), cross(q, r), cross(r, p)};
      const bool has_none = columns.last < columns.first || rows.last < rows.first;
      const bool has_one = columns.last == columns.first && rows.last == rows.first;
      const bool is_beside =
          std::min({edges[0], edges[1], edges[2]}) < 0 && std::max({edges[0], edges[1], edges[2]}) > 0;
      if (has_none || (has_one && is_beside)) {
        count(work, edges[0] + edges[1] + edges[2], counters);
        continue;
      }
    }
    std::copy_n(index, 3, work.kept_indices + 3 * static_cast<std::size_t>(kept));
    work.kept_triangles[kept++] = work.triangles[i];
  }
  return kept;
}

}  // namespace velum
