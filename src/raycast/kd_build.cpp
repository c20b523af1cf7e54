#include "kd_build.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace velum {
namespace {

/// A side of a box across an axis. Sorted by place, then ends before flat ones before beginnings.
struct Side {
  enum Kind : std::uint8_t { end, flat, begin };
  float place;
  Kind kind;
  std::uint32_t item;  ///< index, not id

  bool operator<(const Side& other) const {
    if (place != other.place) return place < other.place;
    return kind != other.kind ? kind < other.kind : item < other.item;
  }
};

/// Items of a cell: the sides of their boxes along x, y and z, and how many they are.
struct Cell {
  Box box;
  std::array<std::vector<Side>, 3> sides;
  std::size_t count = 0;
};

struct Plane {
  double cost = std::numeric_limits<double>::infinity();
  int axis = -1;
  float place = 0.0f;
};

double half_area(const glm::dvec3& s) {
  return s.x * s.y + s.y * s.z + s.z * s.x;
}

class KdBuilder {
 public:
  KdBuilder(const std::vector<BoxedItem>& items, const KdSettings& settings)
      : items_(items), settings_(settings), place_of_(items.size()) {}

  KdArrays run() {
    Cell root;
    root.count = items_.size();
    root.box = arrays_.cell = box_around(items_);
    for (int axis = 0; axis < 3; ++axis) root.sides[static_cast<std::size_t>(axis)] = sorted_sides(axis);
    divide(std::move(root), kd_depth(settings_, items_.size()));
    return std::move(arrays_);
  }

 private:
  std::vector<Side> sorted_sides(int axis) const {
    std::vector<Side> sides;
    for (std::uint32_t i = 0; i < items_.size(); ++i) {
      const Box& box = items_[i].box;
      if (box.lower[axis] == box.upper[axis]) {
        sides.push_back({box.lower[axis], Side::flat, i});
      } else {
        sides.push_back({box.lower[axis], Side::begin, i});
        sides.push_back({box.upper[axis], Side::end, i});
      }
    }
    std::sort(sides.begin(), sides.end());
    return sides;
  }

  /// c_T + c_I·(p_L·n_L + p_R·n_R).
  double cost(const Box& box, int axis, float place, std::size_t left, std::size_t right) const {
    const glm::dvec3 size = glm::dvec3(box.upper) - glm::dvec3(box.lower);
    glm::dvec3 left_size = size, right_size = size;
    left_size[axis] = static_cast<double>(place) - static_cast<double>(box.lower[axis]);
    right_size[axis] = static_cast<double>(box.upper[axis]) - static_cast<double>(place);
    const double met = (half_area(left_size) * static_cast<double>(left) +
                        half_area(right_size) * static_cast<double>(right)) /
                       half_area(size);
    const double bonus = left == 0 || right == 0 ? 1.0 - settings_.empty_bonus : 1.0;
    return bonus * (settings_.step_cost + settings_.triangle_cost * met);
  }

  /// Sweeps a plane along an axis: what ends before it no longer counts on the right, what begins before it
  /// counts on the left. Flat items in the plane count on the left.
  void sweep(const Cell& cell, int axis, Plane& best) const {
    const std::vector<Side>& sides = cell.sides[static_cast<std::size_t>(axis)];
    std::size_t left = 0, right = cell.count;
    for (std::size_t i = 0; i < sides.size();) {
      const float place = sides[i].place;
      std::size_t counts[3] = {};
      for (; i < sides.size() && sides[i].place == place; ++i) ++counts[sides[i].kind];
      left += counts[Side::flat];
      right -= counts[Side::end] + counts[Side::flat];
      if (place > cell.box.lower[axis] && place < cell.box.upper[axis]) {
        const double c = cost(cell.box, axis, place, left, right);
        if (c < best.cost) best = {c, axis, place};
      }
      left += counts[Side::begin];
    }
  }

  enum Place : std::uint8_t { on_left = 1, on_right = 2, on_both = 3 };

  Place place_of(const Box& box, const Plane& plane) const {
    const float lower = box.lower[plane.axis], upper = box.upper[plane.axis];
    const bool left = lower < plane.place || upper <= plane.place;
    const bool right = upper > plane.place;
    return static_cast<Place>((left ? on_left : 0) | (right ? on_right : 0));
  }

  /// The items of one side of the plane, in the order they have.
  Cell part(const Cell& cell, const Plane& plane, Place side) const {
    Cell result;
    result.box = cell.box;
    (side == on_left ? result.box.upper : result.box.lower)[plane.axis] = plane.place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const Side& s : cell.sides[axis]) {
        if ((place_of_[s.item] & side) == 0) continue;
        result.sides[axis].push_back(s);
        result.count += axis == 0 && s.kind != Side::end;
      }
    }
    return result;
  }

  void make_leaf(const Cell& cell) {
    KdNode& node = arrays_.nodes.back();
    node.word = static_cast<std::uint32_t>(arrays_.ids.size()) << 2 | 3u;
    node.count = static_cast<std::uint32_t>(cell.count);
    for (const Side& s : cell.sides[0]) {
      if (s.kind != Side::end) arrays_.ids.push_back(items_[s.item].id);
    }
  }

  void divide(Cell cell, int depth) {
    arrays_.nodes.emplace_back();
    Plane best;
    if (depth > 0 && cell.count > 1) {
      for (int axis = 0; axis < 3; ++axis) sweep(cell, axis, best);
    }
    if (!(best.cost < settings_.triangle_cost * static_cast<double>(cell.count))) {
      make_leaf(cell);
      return;
    }
    for (const Side& s : cell.sides[0]) place_of_[s.item] = place_of(items_[s.item].box, best);
    Cell left = part(cell, best, on_left);
    Cell right = part(cell, best, on_right);
    cell = {};
    const std::size_t node = arrays_.nodes.size() - 1;
    arrays_.nodes[node].split = best.place;
    divide(std::move(left), depth - 1);
    arrays_.nodes[node].word =
        static_cast<std::uint32_t>(arrays_.nodes.size()) << 2 | static_cast<std::uint32_t>(best.axis);
    divide(std::move(right), depth - 1);
  }

  const std::vector<BoxedItem>& items_;
  const KdSettings& settings_;
  std::vector<Place> place_of_;  ///< of each item, while a cell is divided
  KdArrays arrays_;
};

}  // namespace

int kd_depth(const KdSettings& settings, std::size_t n) {
  if (settings.most_depth > 0) return std::min(settings.most_depth, KdArrays::most_depth);
  return 8 + static_cast<int>(1.3 * static_cast<double>(std::bit_width(n)));
}

KdArrays build_kd_tree(const std::vector<BoxedItem>& items, const KdSettings& settings) {
  return KdBuilder(items, settings).run();
}

}  // namespace velum
