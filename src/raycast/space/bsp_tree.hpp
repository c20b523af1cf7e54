#pragma once

#include <optional>

#include "../../base/plane.hpp"
#include "../accelerator.hpp"

namespace velum {

struct BspSettings {
  std::uint32_t leaf_size = 6;  ///< cells with more triangles are divided
  int most_depth = 40;
  int candidates = 12;  ///< triangles whose planes are tried
};

/// A binary space partition by planes in any direction, each that of a triangle (Fuchs, Kedem & Naylor 1980,
/// "On Visible Surface Generation by A Priori Tree Structures"). Every cell is a convex polyhedron. Triangles
/// that a plane cuts are referenced on both sides; those in it stay at the node.
class BspTree final : public Accelerator {
 public:
  explicit BspTree(const TriangleSet& triangles, const BspSettings& settings = {});
  std::size_t memory() const override {
    return nodes_.size() * sizeof(Node) + ids_.size() * sizeof(ids_[0]) + all_.size() * sizeof(all_[0]);
  }

  /// The cell that a point is in, by one test per level: its number, 0 … cell_count()-1. Points in a plane
  /// are on its positive side.
  std::uint32_t cell_of(const glm::dvec3& point) const;
  std::uint32_t cell_count() const { return cells_; }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  struct Node {
    glm::dvec3 normal{0.0};                          ///< unit length
    glm::dvec3 point{0.0};                           ///< of the plane
    Box box;                                         ///< around the triangles at and below the node
    std::uint32_t negative = none, positive = none;  ///< children; a leaf has none
    std::uint32_t first = 0, count = 0;              ///< of ids_: in a leaf, or in the plane
    std::uint32_t cell = none;                       ///< of a leaf

    bool is_leaf() const { return cell != none; }
    double height(const glm::dvec3& p) const {
      const glm::dvec3 v = p - point;
      return normal.x * v.x + normal.y * v.y + normal.z * v.z;
    }
  };
  /// Which triangles go where.
  struct Parts {
    std::vector<BoxedItem> negative, positive, inside;
  };

  void traverse(Search& search) const override;
  bool test(const Node& node, Search& search, Mailboxes& mailboxes) const;
  std::uint32_t divide(const std::vector<BoxedItem>& items, const BspSettings& settings, int depth);
  std::optional<Node> best_plane(const std::vector<BoxedItem>& items, const BspSettings& settings) const;
  std::optional<Node> plane_of(std::uint32_t triangle) const;
  Parts parts_of(const std::vector<BoxedItem>& items, const Node& plane) const;
  void keep(std::uint32_t node, const std::vector<BoxedItem>& items);

  double pad_ = 0.0;  ///< what is nearer to a plane is on both sides of it
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> ids_;
  std::vector<std::uint32_t> all_;  ///< every triangle, for rays from so far away that the pad is too small
  std::uint32_t cells_ = 0;
};

}  // namespace velum
