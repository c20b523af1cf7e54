#include "search.hpp"

#include "intersection/watertight.hpp"

namespace velum {

void Search::decide(std::uint32_t triangle, const Triangle& corners) {
  if (const auto found = intersect_watertight(ray, corners)) take({found->t, triangle, found->barycentric});
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
