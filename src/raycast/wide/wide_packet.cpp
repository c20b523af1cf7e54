// Eight rays at once through a wide hierarchy.
#include <type_traits>

#include "../intersection/watertight.hpp"
#include "wide_bvh.hpp"
#include "wide_packet_kernels.hpp"

namespace velum {
namespace {

/// The kernel reads a ray as eight numbers in a row.
static_assert(sizeof(ViewRay) == 8 * sizeof(double) && std::is_standard_layout_v<ViewRay>);

/// Rays that a kernel asks about.
struct RayGroup {
  std::span<const ViewRay> rays;
  const Aabb& bounds;

  bool decide(const TriangleBlock& block, std::size_t lane, std::size_t i, WideHit& hit) const {
    const ViewRay& view = i < rays.size() ? rays[i] : rays.back();
    return decide_exactly(PreparedRay(view.ray, view.range, bounds), block, lane, hit);
  }
};

RayHit hit_of(const PacketHits& hits, std::size_t i) {
  return {hits.t[i],
          static_cast<std::uint32_t>(hits.triangle[i]),
          {hits.barycentric[0][i], hits.barycentric[1][i], hits.barycentric[2][i]}};
}

}  // namespace

bool WideBvh::first_hits_together(std::span<const ViewRay> rays, std::span<RayHit> hits,
                                  CastCounters& counters, const HitFilter& filter) const {
  if (packet_kernel_ == nullptr || tree_.is_empty()) return false;
  RayGroup group{rays, bounds()};
  const PacketQuery query{
      &rays[0].ray.origin.x,
      rays.size(),
      &float_bounds_,
      &group,
      filter.accepts,
      filter.context,
      [](void* self, const TriangleBlock& block, std::size_t lane, std::size_t i, WideHit& hit) {
        return static_cast<const RayGroup*>(self)->decide(block, lane, i, hit);
      }};
  PacketHits found;
  const PacketOutcome outcome = packet_kernel_(tree_.view(), query, found, counters);
  if (outcome == PacketOutcome::refused) return false;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    hits[i] = outcome == PacketOutcome::cast ? hit_of(found, i) : RayHit{};
    counters.hits += hits[i].is_hit();
  }
  counters.rays += rays.size();
  return true;
}

}  // namespace velum
