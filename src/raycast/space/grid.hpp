#pragma once

#include <glm/vec3.hpp>

#include "../accelerator.hpp"

namespace velum {

struct GridSettings {
  double cells_per_side = 3.0;  ///< times ∛n along a cube's side, the lecture's rule
  int levels = 1;               ///< grids inside crowded cells, so many deep
  std::uint32_t crowded = 16;   ///< a cell with more triangles is given a grid of its own, where levels allow
  /// Cells are made larger until there are at most so many references from cells to triangles for each
  /// triangle, and 1024 more. Grids inside cells may have three times as many again.
  double most_references = 32.0;
};

/// Equal cells over the bounds; in each a list of the triangles whose boxes it meets. With several levels,
/// crowded cells hold a grid themselves: the answer to the ball in the stadium, all of which falls into one
/// cell of a uniform grid.
class Grid final : public Accelerator {
 public:
  explicit Grid(const TriangleSet& triangles, const GridSettings& settings = {});
  std::size_t memory() const override;

 private:
  /// A grid, the outermost one or one inside a cell.
  struct Level {
    glm::dvec3 lower{0.0}, upper{0.0}, cell_size{0.0};
    glm::ivec3 cells{1};
    std::size_t first_cell = 0;  ///< its cells in cells_

    double plane(int axis, int i) const { return lower[axis] + cell_size[axis] * i; }
    std::size_t index(const glm::ivec3& c) const {
      return first_cell +
             (static_cast<std::size_t>(c.z) * static_cast<std::size_t>(cells.y) +
              static_cast<std::size_t>(c.y)) *
                 static_cast<std::size_t>(cells.x) +
             static_cast<std::size_t>(c.x);
    }
  };
  /// Triangles first … first+count-1 of ids_; or, where count says so, the level `first`.
  struct Cell {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    static constexpr std::uint32_t is_level = 0xFFFFFFFFu;
  };
  /// The cells that an item's box meets, with the pad.
  struct CellRange {
    glm::ivec3 first, last;
  };

  void traverse(Search& search) const override;
  void walk(const Level& level, Search& search, Mailboxes& mailboxes) const;
  void look_into(const Cell& cell, Search& search, Mailboxes& mailboxes) const;

  /// A grid for items in a cell, over the part of the cell that they take up.
  Level level_over(const std::vector<BoxedItem>& items, const Aabb& cell, const GridSettings& settings) const;
  static double room(double n, const GridSettings& settings);
  std::uint64_t references(const Level& level, const std::vector<BoxedItem>& items) const;
  void coarsen(Level& level, const std::vector<BoxedItem>& items, const GridSettings& settings) const;
  bool is_worth_it(const Level& level, const std::vector<BoxedItem>& items,
                   const GridSettings& settings) const;
  std::uint32_t add_level(Level level, const std::vector<BoxedItem>& items, const GridSettings& settings,
                          int levels);
  void fill(const Level& level, const std::vector<BoxedItem>& items);
  void nest(const Level& level, const std::vector<BoxedItem>& items, const GridSettings& settings,
            int levels);
  std::vector<BoxedItem> items_in(const Cell& cell, const std::vector<BoxedItem>& items) const;
  CellRange range_of(const Level& level, const Box& box) const;

  double pad_ = 0.0;  ///< boxes count as larger by this: more than the place of a ray can be wrong by
  std::vector<std::uint32_t> all_;  ///< every triangle, for rays from so far away that the pad is too small
  std::vector<Level> levels_;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> ids_;
};

}  // namespace velum
