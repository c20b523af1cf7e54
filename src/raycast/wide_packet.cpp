// Eight rays at once through a wide hierarchy.
#include <algorithm>
#include <new>
#include <type_traits>
#include <utility>

#include "wide_bvh.hpp"
#include "wide_packet_kernels.hpp"
#include "wide_ray.hpp"

namespace velum {
namespace {

constexpr std::size_t packet_size = WidePacket::size;

/// Room for eight things that are made only where a ray comes to triangles; most rays never do.
template <typename T>
class Places {
 public:
  template <typename... Arguments>
  T& make(std::size_t i, Arguments&&... arguments) {
    return *::new (static_cast<void*>(&places_[i].thing)) T(std::forward<Arguments>(arguments)...);
  }
  T& operator[](std::size_t i) { return places_[i].thing; }
  const T& operator[](std::size_t i) const { return places_[i].thing; }

 private:
  static_assert(std::is_trivially_destructible_v<T>);
  union Place {
    Place() {}
    T thing;
  };
  Place places_[packet_size];
};

/// The kernel reads a ray as eight numbers in a row.
static_assert(sizeof(ViewRay) == 8 * sizeof(double) && std::is_standard_layout_v<ViewRay>);

WidePacket packet_of(std::span<const ViewRay> rays, const Aabb& bounds) {
  WidePacket packet;
  for (std::size_t i = 0; i < packet_size; ++i) {
    packet.ray[i] = reinterpret_cast<const double*>(&rays[std::min(i, rays.size() - 1)]);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    packet.bounds[0][axis] = static_cast<float>(bounds.lower[static_cast<int>(axis)]);
    packet.bounds[1][axis] = static_cast<float>(bounds.upper[static_cast<int>(axis)]);
  }
  return packet;
}

/// Prepares the rays when the kernel has come to triangles, and decides what it proposes.
class PacketDecision {
 public:
  PacketDecision(std::span<const ViewRay> rays, const WideBvh& bvh, const HitFilter& filter,
                 CastCounters& counters)
      : rays_(rays), bvh_(bvh), filter_(filter), counters_(counters) {}

  const WideLines* prepare() {
    for (std::size_t i = 0; i < packet_size; ++i) {
      const ViewRay& view = rays_[std::min(i, rays_.size() - 1)];
      const PreparedRay& ray = prepared_.make(i, view.ray, view.range, bvh_.bounds());
      if (!ray.usable || ray.kz != prepared_[0].kz) return nullptr;
      set_line(ray, i);
      searches_.make(i, bvh_.triangles(), ray, Search::Aim::first, filter_, counters_);
      scale_[i] = scale_of(ray);
      set_upper(i);
    }
    is_prepared_ = true;
    return &lines_;
  }

  float meet(const TriangleBlock& block, std::uint32_t triangle, std::uint32_t lanes) {
    const Triangle corners = triangle_in(block, triangle);
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      if ((lanes >> i & 1u) == 0) continue;
      searches_[i].decide(block.id[triangle], corners);
      set_upper(i);
    }
    return *std::max_element(upper_, upper_ + rays_.size());
  }

  RayHit hit(std::size_t i) const { return is_prepared_ ? searches_[i].hit() : RayHit{}; }

 private:
  void set_line(const PreparedRay& ray, std::size_t i) {
    const int axes[3] = {ray.kx, ray.ky, ray.kz};
    for (std::size_t k = 0; k < 3; ++k) {
      lines_.origin[k][i] = ray.ray.origin[axes[k]];
      lines_.axis[k] = static_cast<std::uint32_t>(axes[k]);
    }
    lines_.shear_x[i] = ray.shear_x;
    lines_.shear_y[i] = ray.shear_y;
  }
  void set_upper(std::size_t i) { upper_[i] = rounded_up(searches_[i].limit() * scale_[i]); }

  std::span<const ViewRay> rays_;
  const WideBvh& bvh_;
  const HitFilter& filter_;
  CastCounters& counters_;
  bool is_prepared_ = false;
  Places<PreparedRay> prepared_;
  Places<Search> searches_;
  double scale_[packet_size];
  float upper_[packet_size];
  WideLines lines_;
};

}  // namespace

bool WideBvh::first_hits_together(std::span<const ViewRay> rays, std::span<RayHit> hits,
                                  CastCounters& counters, const HitFilter& filter) const {
  if (packet_kernel_ == nullptr || tree_.is_empty()) return false;
  PacketDecision decision(rays, *this, filter, counters);
  const PacketMeeting meeting{
      &decision, [](void* context) { return static_cast<PacketDecision*>(context)->prepare(); },
      [](void* context, const TriangleBlock& block, std::uint32_t triangle, std::uint32_t lanes) {
        return static_cast<PacketDecision*>(context)->meet(block, triangle, lanes);
      }};
  WideCounts counts;
  if (!packet_kernel_(tree_.view(), packet_of(rays, bounds()), meeting, counts)) return false;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    hits[i] = decision.hit(i);
    counters.hits += hits[i].is_hit();
  }
  counters.rays += rays.size();
  counters.nodes += counts.nodes;
  counters.boxes += counts.boxes;
  counters.tests += counts.tests;
  return true;
}

}  // namespace velum
