// Dividing space by the planes of triangles.
#include <algorithm>
#include <glm/geometric.hpp>

#include "bsp_tree.hpp"

namespace velum {

BspTree::BspTree(const TriangleSet& triangles, const BspSettings& settings) : Accelerator(triangles) {
  const std::vector<BoxedItem> items = boxed_triangles();
  if (items.empty()) return;
  for (const BoxedItem& item : items) all_.push_back(item.id);
  const glm::dvec3 size = bounds().size();
  pad_ = 0x1.0p-24 * std::max({size.x, size.y, size.z});
  divide(items, settings, 0);
}

std::optional<BspTree::Node> BspTree::plane_of(std::uint32_t triangle) const {
  const Triangle t = triangles()[triangle];
  const glm::dvec3 normal = glm::cross(t.b - t.a, t.c - t.a);
  const double length = glm::length(normal);
  if (!(length > 0.0)) return {};
  Node plane;
  plane.normal = normal / length;
  plane.point = t.a;
  return plane;
}

BspTree::Parts BspTree::parts_of(const std::vector<BoxedItem>& items, const Node& plane) const {
  Parts parts;
  for (const BoxedItem& item : items) {
    const Triangle t = triangles()[item.id];
    const auto [least, most] = std::minmax({plane.height(t.a), plane.height(t.b), plane.height(t.c)});
    if (least >= -pad_ && most <= pad_) {
      parts.inside.push_back(item);
      continue;
    }
    if (least < pad_) parts.negative.push_back(item);
    if (most > -pad_) parts.positive.push_back(item);
  }
  return parts;
}

std::optional<BspTree::Node> BspTree::best_plane(const std::vector<BoxedItem>& items,
                                                 const BspSettings& settings) const {
  std::optional<Node> best;
  // A plane is good if it leaves few triangles on the fuller side and cuts few.
  std::size_t least = items.size() * 3;
  const std::size_t step =
      std::max<std::size_t>(1, items.size() / static_cast<std::size_t>(settings.candidates));
  for (std::size_t i = step / 2; i < items.size(); i += step) {
    const std::optional<Node> plane = plane_of(items[i].id);
    if (!plane) continue;
    const Parts parts = parts_of(items, *plane);
    const std::size_t fuller = std::max(parts.negative.size(), parts.positive.size());
    const std::size_t score = 2 * fuller + parts.negative.size() + parts.positive.size();
    if (fuller >= items.size() || score >= least) continue;
    least = score;
    best = plane;
  }
  return best;
}

void BspTree::keep(std::uint32_t node, const std::vector<BoxedItem>& items) {
  nodes_[node].first = static_cast<std::uint32_t>(ids_.size());
  nodes_[node].count = static_cast<std::uint32_t>(items.size());
  for (const BoxedItem& item : items) ids_.push_back(item.id);
}

std::uint32_t BspTree::divide(const std::vector<BoxedItem>& items, const BspSettings& settings, int depth) {
  const auto node = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  std::optional<Node> plane;
  if (items.size() > settings.leaf_size && depth < settings.most_depth) plane = best_plane(items, settings);
  if (plane) nodes_[node] = *plane;
  nodes_[node].box = box_around(items);
  if (!plane) {
    nodes_[node].cell = cells_++;
    keep(node, items);
    return node;
  }
  const Parts parts = parts_of(items, *plane);
  keep(node, parts.inside);
  const std::uint32_t negative = divide(parts.negative, settings, depth + 1);
  const std::uint32_t positive = divide(parts.positive, settings, depth + 1);
  nodes_[node].negative = negative;
  nodes_[node].positive = positive;
  return node;
}

std::uint32_t BspTree::cell_of(const glm::dvec3& point) const {
  std::uint32_t node = 0;
  while (!nodes_[node].is_leaf()) {
    node = nodes_[node].height(point) < 0.0 ? nodes_[node].negative : nodes_[node].positive;
  }
  return nodes_[node].cell;
}

}  // namespace velum
