#pragma once

#include <vector>

#include "random.hpp"
#include "visibility/screen_triangle.hpp"

namespace velum {

/// A planar triangulation of a square: a grid whose inner vertices are moved at random, each cell split along
/// a random diagonal. `whole` puts vertices on whole pixels; `jitter` near 1 makes slivers, beyond 0.5 cells
/// may fold over.
struct Triangulation {
  std::vector<ScreenTriangle> triangles;
  std::uint64_t reversed = 0;
};

inline Triangulation jittered_grid(Random& random, int cells, int size, double jitter, bool whole) {
  std::vector<SnappedVertex> vertices;
  const double step = static_cast<double>(size) / cells;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const bool inner = i > 0 && j > 0 && i < cells && j < cells;
      const double x = step * (i + (inner ? random.uniform(-jitter, jitter) : 0.0));
      const double y = step * (j + (inner ? random.uniform(-jitter, jitter) : 0.0));
      const int unit = whole ? subpixels : 1;
      const auto snapped = [&](double v) {
        return static_cast<std::int32_t>(v * subpixels / unit + 0.5) * unit;
      };
      vertices.push_back({snapped(x), snapped(y)});
    }
  }
  Triangulation result;
  const auto add = [&](int a, int b, int c) {
    ScreenTriangle t;
    const auto at = [&](int i) { return vertices[static_cast<std::size_t>(i)]; };
    t.vertices = {at(a), at(b), at(c)};
    t.primitive = static_cast<std::uint32_t>(result.triangles.size());
    result.reversed += doubled_area(t.vertices) < 0;
    result.triangles.push_back(t);
  };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const int a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
      if (random.next() & 1u) {
        add(a, b, d), add(a, d, c);
      } else {
        add(a, b, c), add(b, d, c);
      }
    }
  }
  return result;
}

}  // namespace velum
