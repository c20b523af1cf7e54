// The rules that need no cost: median of the items, middle of the box.
#include <algorithm>

#include "bvh_build.hpp"

namespace velum {
namespace {

std::size_t split_along(const BvhTask& task, int axis, std::uint32_t leaf_size) {
  if (task.items.size() <= leaf_size) return 0;
  const std::size_t half = task.items.size() / 2;
  std::nth_element(task.items.begin(), task.items.begin() + static_cast<std::ptrdiff_t>(half),
                   task.items.end(), [axis](const BoxedItem& a, const BoxedItem& b) {
                     const float ca = a.centre(axis), cb = b.centre(axis);
                     return ca < cb || (ca == cb && a.id < b.id);
                   });
  return half;
}

int longest_axis(const glm::vec3& size) {
  return size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
}

}  // namespace

std::size_t split_at_median(const BvhTask& task, const BvhSettings& settings) {
  return split_along(task, settings.median_axis, settings.leaf_size);
}

std::size_t split_at_cyclic_median(const BvhTask& task, const BvhSettings& settings) {
  return split_along(task, task.depth % 3, settings.leaf_size);
}

std::size_t split_at_midpoint(const BvhTask& task, const BvhSettings& settings) {
  if (task.items.size() <= settings.leaf_size) return 0;
  const int axis = longest_axis(task.box.size());
  const float middle = task.box.lower[axis] + task.box.upper[axis];
  const auto right = std::stable_partition(task.items.begin(), task.items.end(),
                                           [=](const BoxedItem& item) { return item.centre(axis) < middle; });
  const auto left = static_cast<std::size_t>(right - task.items.begin());
  if (left == 0 || left == task.items.size()) return split_along(task, axis, settings.leaf_size);
  return left;
}

}  // namespace velum
