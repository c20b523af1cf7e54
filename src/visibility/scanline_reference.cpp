#include <algorithm>

#include "scanline.hpp"
#include "span_depth.hpp"

namespace velum {
namespace {

/// Largest whole number ≤ a / b. @pre b > 0
constexpr std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
  return a / b - (a % b < 0 ? 1 : 0);
}

/// Smallest whole number ≥ a / b. @pre b > 0
constexpr std::int64_t ceil_divide(std::int64_t a, std::int64_t b) {
  return -floor_divide(-a, b);
}

/// The first row whose centre is at or below a snapped coordinate.
std::int32_t first_row_from(std::int32_t y) {
  return static_cast<std::int32_t>(ceil_divide(std::int64_t{y} - subpixels / 2, subpixels));
}

/// The edge at row `row`: the only divisions of its life. @pre upper.y < lower.y
ScanlineEdge edge_at(const SnappedVertex& upper, const SnappedVertex& lower, std::int32_t row) {
  const std::int64_t width = std::int64_t{lower.x} - upper.x;
  const std::int64_t height = std::int64_t{lower.y} - upper.y;
  const std::int64_t down = std::int64_t{row} * subpixels + subpixels / 2 - upper.y;
  ScanlineEdge edge;
  edge.row = row;
  edge.denominator = height * subpixels;
  // The crossing in pixels, counted from the centre of pixel 0, is numerator / denominator.
  const std::int64_t numerator = (std::int64_t{upper.x} - subpixels / 2) * height + width * down;
  const std::int64_t n = ceil_divide(numerator, edge.denominator);
  edge.n = static_cast<std::int32_t>(n);
  edge.excess = n * edge.denominator - numerator;
  const std::int64_t step = floor_divide(width, height);
  edge.step = static_cast<std::int32_t>(step);
  edge.step_remainder = (width - step * height) * subpixels;
  return edge;
}

/// To the next row: the crossing moves by step + step_remainder / denominator (Bresenham 1965).
void advance(ScanlineEdge& edge) {
  edge.n += edge.step;
  edge.excess -= edge.step_remainder;
  if (edge.excess < 0) {
    edge.n += 1;
    edge.excess += edge.denominator;
  }
  ++edge.row;
}

/// The non-horizontal edges of a triangle that have a row inside the rectangle, from their first row there.
void append_edges(const ScreenTriangle& triangle, std::uint32_t index, const Rect& rect,
                  std::vector<ScanlineEdge>& out) {
  for (std::size_t i = 0; i < 3; ++i) {
    SnappedVertex upper = triangle.vertices[i];
    SnappedVertex lower = triangle.vertices[(i + 1) % 3];
    if (upper.y > lower.y) std::swap(upper, lower);
    const std::int32_t row = std::max(first_row_from(upper.y), rect.top);
    const std::int32_t end_row = std::min(first_row_from(lower.y), rect.bottom());
    if (row >= end_row) continue;
    ScanlineEdge edge = edge_at(upper, lower, row);
    edge.triangle = index;
    edge.end_row = end_row;
    out.push_back(edge);
  }
}

/// Sorts the edges into buckets by first row; within a row they stay in the order of the triangles.
void sort_into_buckets(const Rect& rect, ScanlineTables& tables) {
  std::vector<std::uint32_t>& first = tables.first_edge_of_row;
  first.assign(static_cast<std::size_t>(rect.height) + 2, 0);
  const auto bucket = [&rect](const ScanlineEdge& edge) {
    return static_cast<std::size_t>(edge.row - rect.top);
  };
  for (const ScanlineEdge& edge : tables.unsorted) ++first[bucket(edge) + 2];
  for (std::size_t i = 2; i < first.size(); ++i) first[i] += first[i - 1];
  tables.edge_table.resize(tables.unsorted.size());
  for (const ScanlineEdge& edge : tables.unsorted) tables.edge_table[first[bucket(edge) + 1]++] = edge;
}

void build_edge_table(std::span<const ScreenTriangle> triangles, const Rect& rect, ScanlineTables& tables,
                      RasterCounts& counts) {
  tables.unsorted.clear();
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (doubled_area(triangles[i].vertices) == 0) {
      ++counts.zero_area;
    } else {
      append_edges(triangles[i], i, rect, tables.unsorted);
    }
  }
  sort_into_buckets(rect, tables);
}

/// Takes the edges that ended out of the active list, and those that begin at this row in.
void update_active_edges(std::int32_t row, const Rect& rect, ScanlineTables& tables) {
  std::erase_if(tables.active, [row](const ScanlineEdge& edge) { return edge.end_row <= row; });
  const auto bucket = static_cast<std::size_t>(row - rect.top);
  const auto begin = tables.edge_table.begin() + tables.first_edge_of_row[bucket];
  const auto end = tables.edge_table.begin() + tables.first_edge_of_row[bucket + 1];
  if (begin == end) return;
  tables.merged.resize(tables.active.size() + static_cast<std::size_t>(end - begin));
  std::merge(tables.active.begin(), tables.active.end(), begin, end, tables.merged.begin(),
             [](const ScanlineEdge& a, const ScanlineEdge& b) { return a.triangle < b.triangle; });
  std::swap(tables.active, tables.merged);
}

/// The pixels first ≤ x < end of a row.
struct Span {
  int row, first, end;
};

/// Keeps the nearer of a fragment and what the buffer holds. Picture coordinates.
void keep_nearer(float r, std::uint32_t id, int x, int y, const RasterTarget& target, RasterCounts& counts) {
  ++counts.fragments;
  if (target.lists != nullptr) return target.lists->add(x, y, r, id);
  float& buffer_r = target.buffer.reversed_depth.at(x - target.rect.left, y - target.rect.top);
  std::uint32_t& buffer_id = target.buffer.primitive.at(x - target.rect.left, y - target.rect.top);
  if (nearness(r, id) <= nearness(buffer_r, buffer_id)) return;
  buffer_r = r;
  buffer_id = id;
  ++counts.fragments_written;
}

template <typename Depth, DepthFormat format>
void fill(const Span& span, const ScreenTriangle& triangle, const RasterTarget& target,
          RasterCounts& counts) {
  const int first = std::max(span.first, target.rect.left);
  const int end = std::min(span.end, target.rect.right());
  if (first >= end) return;
  ++counts.spans;
  Depth depth(triangle, span.row, span.first);
  for (int x = span.first; x < first; ++x) depth.at(x);
  for (int x = first; x < end; ++x) {
    const float r = stored_depth<format>(depth.at(x));
    keep_nearer(r, triangle.primitive, x, span.row, target, counts);
  }
}

template <typename Depth, DepthFormat format>
void scan(std::span<const ScreenTriangle> triangles, const RasterTarget& target, ScanlineTables& tables,
          RasterCounts& counts) {
  tables.active.clear();
  for (int row = target.rect.top; row < target.rect.bottom(); ++row) {
    update_active_edges(row, target.rect, tables);
    for (std::size_t i = 0; i + 1 < tables.active.size(); i += 2) {
      const auto [first, end] = std::minmax(tables.active[i].n, tables.active[i + 1].n);
      fill<Depth, format>({row, first, end}, triangles[tables.active[i].triangle], target, counts);
    }
    for (ScanlineEdge& edge : tables.active) advance(edge);
  }
}

}  // namespace

RasterCounts rasterize_scanline(std::span<const ScreenTriangle> triangles, const RasterTarget& target,
                                ZInterpolation z_interpolation, ScanlineTables& tables) {
  RasterCounts counts;
  build_edge_table(triangles, target.rect, tables, counts);
  with_format(target.format, [&](auto format) {
    switch (z_interpolation) {
      case ZInterpolation::edges:
        return scan<EdgeDepth, format.value>(triangles, target, tables, counts);
      case ZInterpolation::incremental:
        return scan<IncrementalDepth, format.value>(triangles, target, tables, counts);
      case ZInterpolation::plane:
        break;
    }
    scan<PlaneDepth, format.value>(triangles, target, tables, counts);
  });
  counts.pixels_tested = counts.fragments;
  // They change places row by row; the next call is to find enough in either.
  tables.merged.reserve(tables.active.capacity());
  tables.active.reserve(tables.merged.capacity());
  return counts;
}

RasterCounts rasterize_scanline(std::span<const ScreenTriangle> triangles, const RasterTarget& target,
                                ZInterpolation z_interpolation) {
  ScanlineTables tables;
  return rasterize_scanline(triangles, target, z_interpolation, tables);
}

}  // namespace velum
