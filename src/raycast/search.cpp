#include "search.hpp"

#include "watertight.hpp"

namespace velum {

std::optional<TriangleHit> Search::intersect_triangle(std::uint32_t triangle) const {
  return intersect_watertight(ray, triangles_[triangle]);
}

void Search::take(const RayHit& found) {
  if (!(found.t >= ray.range.lower && found.t <= limit_)) return;
  if (aim_ == Aim::first && !is_before(found.t, found.triangle, hit_.t, hit_.triangle)) return;
  if (filter_.accepts != nullptr && !filter_.accepts(filter_.context, found.triangle)) return;
  switch (aim_) {
    case Aim::first:
      hit_ = found;
      limit_ = found.t;
      return;
    case Aim::any:
      hit_ = found;
      is_done_ = true;
      return;
    case Aim::all:
      all_->push_back(found);
      return;
  }
}

}  // namespace velum
