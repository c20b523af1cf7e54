// Following a ray from cell to cell.
#include <algorithm>
#include <array>
#include <limits>

#include "../../base/elementary.hpp"
#include "grid.hpp"

namespace velum {
namespace {

/// The three-dimensional digital differential analyser: along each axis the t of the next plane; the nearest
/// of the three is crossed next. Source: Amanatides & Woo 1987, "A Fast Voxel Traversal Algorithm for Ray
/// Tracing". Each t is computed from its plane, not added up, so that errors do not grow along the way. (The
/// lecture's first crossing, x_min + (i+1)·Δx, is that of rays with v > 0; the others leave by plane i.)
template <typename Level>
struct Walk {
  const PreparedRay& ray;
  const Level& level;
  glm::ivec3 cell{0};
  std::array<double, 3> next{};

  Walk(const PreparedRay& ray_in, const Level& level_in, double t) : ray(ray_in), level(level_in) {
    const glm::dvec3 start = ray.ray.at(t);
    for (int axis = 0; axis < 3; ++axis) {
      const double place = level.cell_size[axis] > 0.0
                               ? elementary::floor((start[axis] - level.lower[axis]) / level.cell_size[axis])
                               : 0.0;
      cell[axis] = static_cast<int>(std::clamp(place, 0.0, level.cells[axis] - 1.0));
      find_next(axis);
    }
  }

  /// Through the grid's own sides nothing is crossed: a ray along them stays in until its interval ends.
  void find_next(int axis) {
    const bool ascends = ray.inverse[axis] > 0.0;
    if (cell[axis] == (ascends ? level.cells[axis] - 1 : 0)) {
      next[static_cast<std::size_t>(axis)] = std::numeric_limits<double>::infinity();
      return;
    }
    const int plane = cell[axis] + (ascends ? 1 : 0);
    next[static_cast<std::size_t>(axis)] =
        (level.plane(axis, plane) - ray.ray.origin[axis]) * ray.inverse[axis];
  }

  int next_axis() const {
    const int axis = next[0] <= next[1] ? 0 : 1;
    return next[static_cast<std::size_t>(axis)] <= next[2] ? axis : 2;
  }
  double leaves() const { return next[static_cast<std::size_t>(next_axis())]; }

  /// @pre leaves() is finite
  void step() {
    const int axis = next_axis();
    cell[axis] += ray.inverse[axis] > 0.0 ? 1 : -1;
    find_next(axis);
  }
};

}  // namespace

void Grid::look_into(const Cell& cell, Search& search, Mailboxes& mailboxes) const {
  if (cell.count == Cell::is_level) {
    walk(levels_[cell.first], search, mailboxes);
    return;
  }
  for (std::uint32_t i = 0; i < cell.count; ++i) {
    const std::uint32_t id = ids_[cell.first + i];
    if (!mailboxes.is_first_visit(id)) {
      ++search.counters.mailbox;
      continue;
    }
    search.test(id);
    if (search.is_done()) return;
  }
}

void Grid::walk(const Level& level, Search& search, Mailboxes& mailboxes) const {
  ++search.counters.boxes;
  const glm::dvec3 pad(pad_);
  const Interval inside =
      intersect(search.ray.through(level.lower - pad, level.upper + pad), search.ray.range);
  if (inside.is_empty()) return;
  Walk<Level> walk(search.ray, level, inside.lower);
  for (;; walk.step()) {
    ++search.counters.nodes;
    look_into(cells_[level.index(walk.cell)], search, mailboxes);
    // A hit beyond this cell may have a nearer one before it, in a cell not yet looked into.
    const bool is_last = walk.leaves() > std::min(search.limit(), inside.upper);
    if (search.is_done() || is_last || walk.leaves() == std::numeric_limits<double>::infinity()) return;
  }
}

void Grid::traverse(Search& search) const {
  Mailboxes mailboxes;
  if (search.ray.margin * 16.0 <= pad_) {
    walk(levels_[0], search, mailboxes);
    return;
  }
  for (const std::uint32_t id : all_) {
    search.test(id);
    if (search.is_done()) return;
  }
}

}  // namespace velum
