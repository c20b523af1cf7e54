// Building a grid: how many cells, and what lies in them.
#include "grid.hpp"

#include <algorithm>

#include "../../base/elementary.hpp"

namespace velum {
namespace {

/// The most cells of a grid for each triangle in it: thin grids over flat scenes would have more.
constexpr double most_cells_per_triangle = 32.0;

/// ∛n, by Newton's steps.
double cube_root(double n) {
  double root = 1.0;
  while (root * root * root < n) root *= 2.0;
  for (int i = 0; i < 30; ++i) root -= (root * root * root - n) / (3.0 * root * root);
  return root;
}

/// The most references, and the most cells, of all levels of a nested grid together, times those of the
/// outermost.
constexpr double most_for_all_levels = 4.0;

/// What fits into the numbers of a cell, with a bit to spare.
constexpr double most_numbers = 0x1.0p31;

/// How many cells along each axis: they are about cubes, cells_per_side·∛n along the side of a cube of the
/// same volume.
glm::ivec3 cell_counts(const glm::dvec3& size, std::size_t n, double cells_per_side) {
  const double longest = std::max({size.x, size.y, size.z});
  if (!(longest > 0.0)) return glm::ivec3(1);
  // A flat scene has no volume: sides count as at least a hundredth of the longest.
  const glm::dvec3 sides = glm::max(size, glm::dvec3(longest * 0.01));
  const double wanted = cells_per_side * cells_per_side * cells_per_side * static_cast<double>(n);
  double density = cube_root(wanted / (sides.x / longest * (sides.y / longest) * (sides.z / longest)));
  glm::ivec3 cells(1);
  for (;;) {
    for (int axis = 0; axis < 3; ++axis) {
      cells[axis] = std::clamp(static_cast<int>(density * (size[axis] / longest)), 1, 1024);
    }
    const double count = static_cast<double>(cells.x) * cells.y * cells.z;
    if (count <= 8.0 || count <= most_cells_per_triangle * static_cast<double>(n)) return cells;
    density *= 0.9;
  }
}

}  // namespace

Grid::Grid(const TriangleSet& triangles, const GridSettings& settings) : Accelerator(triangles) {
  const std::vector<BoxedItem> items = boxed_triangles();
  if (items.empty()) return;
  for (const BoxedItem& item : items) all_.push_back(item.id);
  const glm::dvec3 size = bounds().size();
  pad_ = 0x1.0p-24 * std::max({size.x, size.y, size.z});
  Level level = level_over(items, bounds(), settings);
  coarsen(level, items, settings);
  add_level(level, items, settings, settings.levels);
}

/// How many references n triangles may have, by the settings: a small grid has a few more.
double Grid::room(double n, const GridSettings& settings) {
  return std::min(settings.most_references * n + 1024.0, most_numbers);
}

std::size_t Grid::memory() const {
  return levels_.size() * sizeof(Level) + cells_.size() * sizeof(Cell) +
         (ids_.size() + all_.size()) * sizeof(std::uint32_t);
}

Grid::CellRange Grid::range_of(const Level& level, const Box& box) const {
  CellRange range;
  for (int axis = 0; axis < 3; ++axis) {
    const auto cell_at = [&](double place) {
      if (!(level.cell_size[axis] > 0.0)) return 0;
      const double cell = elementary::floor((place - level.lower[axis]) / level.cell_size[axis]);
      return static_cast<int>(std::clamp(cell, 0.0, level.cells[axis] - 1.0));
    };
    range.first[axis] = cell_at(static_cast<double>(box.lower[axis]) - pad_);
    range.last[axis] = cell_at(static_cast<double>(box.upper[axis]) + pad_);
  }
  return range;
}

void Grid::fill(const Level& level, const std::vector<BoxedItem>& items) {
  const auto for_each_cell = [&](const auto& visit) {
    for (const BoxedItem& item : items) {
      const CellRange range = range_of(level, item.box);
      for (int z = range.first.z; z <= range.last.z; ++z) {
        for (int y = range.first.y; y <= range.last.y; ++y) {
          for (int x = range.first.x; x <= range.last.x; ++x) visit(cells_[level.index({x, y, z})], item.id);
        }
      }
    }
  };
  // Counted first, so that the lists stand one after the other without gaps.
  for_each_cell([](Cell& cell, std::uint32_t) { ++cell.count; });
  auto first = static_cast<std::uint32_t>(ids_.size());
  for (std::size_t i = level.first_cell; i < cells_.size(); ++i) {
    cells_[i].first = first;
    first += cells_[i].count;
    cells_[i].count = 0;
  }
  ids_.resize(first);
  for_each_cell([this](Cell& cell, std::uint32_t id) { ids_[cell.first + cell.count++] = id; });
}

std::vector<BoxedItem> Grid::items_in(const Cell& cell, const std::vector<BoxedItem>& items) const {
  std::vector<BoxedItem> inside;
  for (std::uint32_t i = cell.first; i < cell.first + cell.count; ++i) {
    const auto has_id = [](const BoxedItem& item, std::uint32_t wanted) { return item.id < wanted; };
    inside.push_back(*std::lower_bound(items.begin(), items.end(), ids_[i], has_id));
  }
  return inside;
}

Grid::Level Grid::level_over(const std::vector<BoxedItem>& items, const Aabb& cell,
                             const GridSettings& settings) const {
  const Box box = box_around(items);
  Level level;
  level.lower = glm::max(cell.lower, glm::dvec3(box.lower) - pad_);
  level.upper = glm::max(level.lower, glm::min(cell.upper, glm::dvec3(box.upper) + pad_));
  level.cells = cell_counts(level.upper - level.lower, items.size(), settings.cells_per_side);
  level.cell_size = (level.upper - level.lower) / glm::dvec3(level.cells);
  return level;
}

/// How many references to items a level would hold. No more than 2³⁰ cells for each of 2³² items: 64 bits do.
std::uint64_t Grid::references(const Level& level, const std::vector<BoxedItem>& items) const {
  std::uint64_t count = 0;
  for (const BoxedItem& item : items) {
    const CellRange range = range_of(level, item.box);
    const glm::ivec3 cells = range.last - range.first + 1;
    count += static_cast<std::uint64_t>(cells.x) * static_cast<std::uint64_t>(cells.y) *
             static_cast<std::uint64_t>(cells.z);
  }
  return count;
}

/// Makes cells larger until there is room for the references to items. Where many triangles are as large as
/// the grid, each lies in most cells, and memory would grow with the square of their number.
void Grid::coarsen(Level& level, const std::vector<BoxedItem>& items, const GridSettings& settings) const {
  const double most = room(static_cast<double>(items.size()), settings);
  while (level.cells != glm::ivec3(1) && static_cast<double>(references(level, items)) > most) {
    level.cells = glm::max(glm::ivec3(glm::dvec3(level.cells) * 0.8), glm::ivec3(1));
    level.cell_size = (level.upper - level.lower) / glm::dvec3(level.cells);
  }
}

/// Whether items lie in few cells each, and there is room for them: a grid over triangles that are as large
/// as it is has no use.
bool Grid::is_worth_it(const Level& level, const std::vector<BoxedItem>& items,
                       const GridSettings& settings) const {
  constexpr std::size_t most_cells_per_item = 8;
  const std::uint64_t count = references(level, items);
  if (count > most_cells_per_item * items.size()) return false;
  const double most = most_for_all_levels * room(static_cast<double>(all_.size()), settings);
  const double cells = static_cast<double>(level.cells.x) * level.cells.y * level.cells.z;
  return static_cast<double>(ids_.size() + count) <= std::min(most, most_numbers) &&
         static_cast<double>(cells_.size()) + cells <= most;
}

void Grid::nest(const Level& level, const std::vector<BoxedItem>& items, const GridSettings& settings,
                int levels) {
  glm::ivec3 c(0);
  for (c.z = 0; c.z < level.cells.z; ++c.z) {
    for (c.y = 0; c.y < level.cells.y; ++c.y) {
      for (c.x = 0; c.x < level.cells.x; ++c.x) {
        const std::size_t index = level.index(c);
        if (cells_[index].count <= settings.crowded) continue;
        const std::vector<BoxedItem> inside = items_in(cells_[index], items);
        const glm::dvec3 lower(level.plane(0, c.x), level.plane(1, c.y), level.plane(2, c.z));
        const Level child = level_over(inside, {lower, lower + level.cell_size}, settings);
        if (!is_worth_it(child, inside, settings)) continue;
        const std::uint32_t added = add_level(child, inside, settings, levels - 1);
        cells_[index] = {added, Cell::is_level};
      }
    }
  }
}

std::uint32_t Grid::add_level(Level level, const std::vector<BoxedItem>& items, const GridSettings& settings,
                              int levels) {
  level.first_cell = cells_.size();
  const auto index = static_cast<std::uint32_t>(levels_.size());
  levels_.push_back(level);
  cells_.resize(cells_.size() + static_cast<std::size_t>(level.cells.x) *
                                    static_cast<std::size_t>(level.cells.y) *
                                    static_cast<std::size_t>(level.cells.z));
  fill(level, items);
  if (levels > 1) nest(level, items, settings, levels);
  return index;
}

}  // namespace velum
