#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "kd_tree.hpp"

namespace velum {

/// A plane that divides a cell, and what rays are expected to cost then.
struct KdPlane {
  double cost = std::numeric_limits<double>::infinity();
  int axis = -1;
  float place = 0.0f;

  /// Whether the cell is better divided than left alone: T_SAH < T_P.
  bool pays(const KdSettings& settings, std::size_t items) const {
    return cost < settings.triangle_cost * static_cast<double>(items);
  }
};

/// Where an item belongs that has these sides across a plane's axis. What only touches the plane is on the
/// side it comes from; what lies in it is on the left.
enum class KdSide : std::uint8_t { left = 1, right = 2, both = 3 };
inline KdSide side_of(const Box& box, const KdPlane& plane) {
  const float lower = box.lower[plane.axis], upper = box.upper[plane.axis];
  const bool left = lower < plane.place || upper <= plane.place;
  const bool right = upper > plane.place;
  return static_cast<KdSide>((left ? 1 : 0) | (right ? 2 : 0));
}
inline bool is_on(KdSide of, KdSide side) {
  return (static_cast<int>(of) & static_cast<int>(side)) != 0;
}

inline Box half_of(Box cell, const KdPlane& plane, KdSide side) {
  (side == KdSide::left ? cell.upper : cell.lower)[plane.axis] = plane.place;
  return cell;
}

/// The surface-area heuristic for planes across one axis of a cell.
class KdCost {
 public:
  KdCost(const KdSettings& settings, const Box& cell, int axis);
  /// c_T + c_I·(p_L·n_L + p_R·n_R), less the bonus where a side is empty.
  double operator()(double place, double left, double right) const;
  double without_bonus(double place, double left, double right) const;

 private:
  const KdSettings& settings_;
  double lower_, upper_;
  double across_;    ///< area of the plane
  double around_;    ///< half the edge of the plane: what area grows by along the axis
  double per_area_;  ///< 1 / half the cell's area
};

/// The best plane as far as samples tell (Hunt, Mark & Stoll 2006, "Fast kd-tree Construction with an
/// Adaptive Error-Bounded Heuristic"). Per axis, half of the samples count at even distances how many items
/// begin before and end after; the other half go where those counts change most. Between samples the counts
/// are taken to be linear, and so the cost to be quadratic, whose least is found by formula.
/// @param items  of which `inside` are in the cell
KdPlane sampled_plane(const std::vector<BoxedItem>& items, std::span<const std::uint32_t> inside,
                      const Box& cell, const KdSettings& settings);

/// The box around the part of a triangle that lies in a cell, larger by a pad; nothing where there is none.
/// The triangle is cut by the cell's six planes (Sutherland & Hodgman 1974).
std::optional<Box> box_of_part(const Triangle& triangle, const Box& cell, double pad);

/// A float not above a double, respectively not below.
float float_below(double v);
float float_above(double v);

}  // namespace velum
