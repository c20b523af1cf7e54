// The full surface-area heuristic: every division of the sorted items.
#include <algorithm>
#include <limits>

#include "bvh_build.hpp"

namespace velum {
namespace {

void sort_along(std::span<BoxedItem> items, int axis) {
  std::sort(items.begin(), items.end(), [axis](const BoxedItem& a, const BoxedItem& b) {
    const float ca = a.centre(axis), cb = b.centre(axis);
    return ca < cb || (ca == cb && a.id < b.id);
  });
}

struct Division {
  double cost = std::numeric_limits<double>::infinity();  ///< area · items, both sides
  std::size_t left = 0;
  int axis = 0;
};

/// The boxes right of each division from the right, then the divisions from the left.
void sweep(std::span<const BoxedItem> items, int axis, std::vector<double>& right_areas, Division& best) {
  Box box;
  for (std::size_t i = items.size() - 1; i > 0; --i) {
    box.include(items[i].box);
    right_areas[i] = box.half_area();
  }
  box = {};
  for (std::size_t left = 1; left < items.size(); ++left) {
    box.include(items[left - 1].box);
    const double cost = box.half_area() * static_cast<double>(left) +
                        right_areas[left] * static_cast<double>(items.size() - left);
    if (cost < best.cost) best = {cost, left, axis};
  }
}

}  // namespace

std::size_t split_by_sweep(const BvhTask& task, const BvhSettings& settings) {
  std::vector<double> right_areas(task.items.size());
  Division best;
  for (int axis = 0; axis < 3; ++axis) {
    sort_along(task.items, axis);
    sweep(task.items, axis, right_areas, best);
  }
  const double area = task.box.half_area();
  const double as_leaf = static_cast<double>(task.items.size()) * settings.triangle_cost;  // T_P
  const double divided = settings.box_cost + best.cost / area * settings.triangle_cost;    // T_SAH
  if (!(divided <= as_leaf)) return 0;
  if (best.axis != 2) sort_along(task.items, best.axis);
  return best.left;
}

}  // namespace velum
