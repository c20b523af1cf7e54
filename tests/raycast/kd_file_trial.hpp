#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "random_scenes.hpp"
#include "raycast/kd/kd_file.hpp"

/// What a kd-tree's file must stand, whatever its bytes: reading them ends in an Error (read) or a tree, and
/// every ray through that tree finds an end. Says so by throwing std::logic_error.
class KdFileTrial {
 public:
  KdFileTrial() {
    Random random{51};
    for (int i = 0; i < 60; ++i) {
      const glm::vec3 a(random_point(random));
      const double size = i % 8 == 0 ? 1.0 : 0.2;
      triangles_.add(a, a + glm::vec3(random_point(random, size)), a + glm::vec3(random_point(random, size)));
    }
    for (int i = 0; i < 24; ++i) rays_.push_back(hard_ray(random, triangles_));
    for (int axis = 0; axis < 3; ++axis) {
      velum::Ray ray{glm::dvec3(0.0), glm::dvec3(0.0)};
      ray.origin[axis] = 4.0;
      ray.direction[axis] = -1.0;
      rays_.push_back(ray);
    }
  }

  velum::TriangleSet triangles() const { return triangles_.set(); }
  std::vector<std::byte> sound_file(velum::KdWalk walk = velum::KdWalk::ropes,
                                    velum::KdCut cut = velum::KdCut::split) const {
    return kd_tree_bytes(velum::KdTree(triangles_.set(), velum::KdSettings{.walk = walk, .cut = cut}));
  }

  /// @return whether the bytes were taken for a tree
  bool run(std::span<const std::byte> bytes) const {
    using enum velum::KdWalk;
    const auto by_stack = load(bytes, stack);
    if (by_stack == nullptr) return false;
    const auto by_recursion = load(bytes, recursive), by_ropes = load(bytes, ropes);
    for (const velum::Ray& ray : rays_) {
      if (hit(*by_stack, ray) != hit(*by_recursion, ray)) throw std::logic_error("recursion hits another");
      hit(*by_ropes, ray);
    }
    return true;
  }

 private:
  std::unique_ptr<velum::KdTree> load(std::span<const std::byte> bytes, velum::KdWalk walk) const {
    try {
      return kd_tree_from_bytes(bytes, triangles_.set(), "trial", walk);
    } catch (const velum::Error& error) {
      if (error.kind() != velum::ErrorKind::read) throw std::logic_error("another kind of error");
      return nullptr;
    }
  }

  static std::uint32_t hit(const velum::KdTree& tree, const velum::Ray& ray) {
    velum::CastCounters counters;
    std::vector<velum::RayHit> all;
    const std::uint32_t first = tree.first_hit(ray, {}, counters).triangle;
    // By ropes a cell is entered once at most, and inner nodes on the way down to it.
    const std::size_t ways = tree.ropes().is_empty() ? 1 : velum::KdArrays::most_depth;
    if (counters.nodes > tree.nodes().size() * ways) throw std::logic_error("a node was visited twice");
    tree.all_hits(ray, {}, counters, all);
    return first;
  }

  RandomTriangles triangles_;
  std::vector<velum::Ray> rays_;
};
