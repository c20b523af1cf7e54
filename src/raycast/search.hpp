#pragma once

#include <cstdint>
#include <vector>

#include "intersection/prepared_ray.hpp"
#include "ray_hit.hpp"
#include "triangle_set.hpp"

namespace velum {

/// Says whether a triangle counts when a ray hits it; for culling by facing.
struct HitFilter {
  bool (*accepts)(const void* context, std::uint32_t triangle) = nullptr;
  const void* context = nullptr;
};

/// One ray on its way through a structure, and what it wants to know. A structure hands it triangles in any
/// order, as often as it likes, and may leave out all that lies beyond limit().
class Search {
 public:
  enum class Aim { first, any, all };

  /// @param all  where Aim::all puts what it finds; unused otherwise
  Search(const TriangleSet& triangles, const PreparedRay& ray_in, Aim aim, const HitFilter& filter,
         CastCounters& counters_in, std::vector<RayHit>* all = nullptr)
      : ray(ray_in),
        counters(counters_in),
        triangles_(triangles),
        filter_(filter),
        aim_(aim),
        limit_(ray_in.range.upper),
        all_(all) {}

  const PreparedRay& ray;
  CastCounters& counters;

  /// Nothing that begins beyond this t is wanted.
  double limit() const { return limit_; }
  /// Nothing is wanted any more.
  bool is_done() const { return is_done_; }
  const RayHit& hit() const { return hit_; }

  void test(std::uint32_t triangle) {
    ++counters.tests;
    decide(triangle, triangles_[triangle]);
  }
  /// The same with the triangle's corners at hand; counts nothing.
  void decide(std::uint32_t triangle, const Triangle& corners);

 private:
  void take(const RayHit& found);

  const TriangleSet& triangles_;
  const HitFilter& filter_;
  Aim aim_;
  double limit_;
  bool is_done_ = false;
  RayHit hit_;
  std::vector<RayHit>* all_;
};

/// Remembers which triangles a ray was tested against, where several cells can hold the same one. The
/// lecture's mailbox stands at the triangle and holds the ray's number; here a small table stands at the ray,
/// so that threads share nothing. A triangle that another one drove out is tested again, with the same
/// result.
class Mailboxes {
 public:
  /// Whether the triangle is new; notes it.
  bool is_first_visit(std::uint32_t triangle) {
    std::uint32_t& box = boxes_[triangle % size];
    if (box == triangle + 1) return false;
    box = triangle + 1;
    return true;
  }

 private:
  static constexpr std::uint32_t size = 64;
  std::uint32_t boxes_[size] = {};
};

}  // namespace velum
