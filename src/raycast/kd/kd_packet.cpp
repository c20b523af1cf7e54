#include "kd_packet.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "../../base/contract.hpp"
#include "kd_walk.hpp"

namespace velum {
namespace {

constexpr std::size_t lanes = kd_packet_size;
using Lanes = std::array<double, lanes>;

/// A node and the part of each ray inside its cell: empty for those that do not want it.
struct Visit {
  std::uint32_t node = 0;
  Lanes lower, upper;
};

/// Eight rays on their way, side by side: every step is one loop over all of them, without a branch.
class Packet {
 public:
  Packet(const KdTree& tree, std::span<const Ray> rays, const Interval& range, const HitFilter& filter,
         CastCounters& counters)
      : tree_(tree.arrays()), counters_(counters) {
    for (std::size_t i = 0; i < lanes; ++i) {
      prepared_[i].emplace(rays[i], range, tree.bounds());
      searches_[i].emplace(tree.triangles(), *prepared_[i], Search::Aim::first, filter, counters);
      const PreparedRay& ray = *prepared_[i];
      const Interval inside = intersect(ray.through(tree.bounds().lower, tree.bounds().upper), range);
      root_.lower[i] = inside.lower;
      root_.upper[i] = inside.upper;
      limit_[i] = range.upper;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<int>(axis);
        ahead_[axis][i] = ray.ahead[k];
        behind_[axis][i] = ray.behind[k];
        inverse_[axis][i] = ray.inverse[k];
      }
    }
  }

  /// Whether all rays meet the planes of each axis from the same side, and so all children in the same order.
  bool is_coherent() const {
    for (const Lanes& inverse : inverse_) {
      for (const double v : inverse) {
        if ((v > 0.0) != (inverse[0] > 0.0)) return false;
      }
    }
    return std::all_of(prepared_.begin(), prepared_.end(), [](const auto& ray) { return ray->usable; });
  }

  void walk() {
    counters_.rays += lanes;
    std::array<Visit, KdArrays::most_depth + 1> stack;
    std::size_t waiting = 0;
    stack[waiting++] = root_;
    while (waiting > 0) {
      Visit visit = stack[--waiting];
      bool wanted = is_wanted(visit);
      while (wanted && !tree_.nodes[visit.node].is_leaf()) {
        Visit& far = stack[waiting];
        const Wanted by = divide(visit, far);
        waiting += by.near && by.far;
        if (!by.near) visit = far;
        wanted = by.near || by.far;
      }
      if (wanted) test(visit);
    }
  }

  const RayHit& hit(std::size_t lane) const { return searches_[lane]->hit(); }

 private:
  bool is_wanted(const Visit& visit) const {
    int wanted = 0;
    for (std::size_t i = 0; i < lanes; ++i) {
      wanted |=
          static_cast<int>(visit.lower[i] <= visit.upper[i]) & static_cast<int>(visit.lower[i] <= limit_[i]);
    }
    return wanted != 0;
  }

  /// Whether some ray wants the child.
  struct Wanted {
    bool near, far;
  };

  /// As in the walk of one ray: near up to the plane, far from there on, both with the rays' margins.
  /// @param visit  becomes the near child's
  Wanted divide(Visit& visit, Visit& far) {
    const KdNode& node = tree_.nodes[visit.node];
    ++counters_.nodes;
    ++counters_.boxes;
    const auto axis = static_cast<std::size_t>(node.axis());
    const auto split = static_cast<double>(node.split);
    const bool lower_first = inverse_[axis][0] > 0.0;
    far.node = lower_first ? node.index() : visit.node + 1;
    visit.node = lower_first ? visit.node + 1 : node.index();
    // Of a ray's two crossings of the plane, with the margin before and behind, the one that is first is the
    // same for all rays: it depends on the side they come from.
    const Lanes& first = lower_first ? ahead_[axis] : behind_[axis];
    const Lanes& last = lower_first ? behind_[axis] : ahead_[axis];
    int near_wanted = 0, far_wanted = 0;
    for (std::size_t i = 0; i < lanes; ++i) {
      const double enters = (split - first[i]) * inverse_[axis][i];
      const double leaves = (split - last[i]) * inverse_[axis][i];
      const double lower = visit.lower[i], upper = visit.upper[i];
      const double near_upper = leaves < upper ? leaves : upper;
      const double far_lower = enters > lower ? enters : lower;
      near_wanted |= static_cast<int>(lower <= near_upper) & static_cast<int>(lower <= limit_[i]);
      far_wanted |= static_cast<int>(far_lower <= upper) & static_cast<int>(far_lower <= limit_[i]);
      visit.upper[i] = near_upper;
      far.lower[i] = far_lower;
      far.upper[i] = upper;
    }
    return {near_wanted != 0, far_wanted != 0};
  }

  void test(const Visit& leaf_visit) {
    const KdNode& leaf = tree_.nodes[leaf_visit.node];
    ++counters_.nodes;
    for (std::uint32_t k = 0; k < leaf.count; ++k) {
      const std::uint32_t id = tree_.ids[leaf.index() + k];
      for (std::size_t i = 0; i < lanes; ++i) {
        if (!(leaf_visit.lower[i] <= leaf_visit.upper[i] && leaf_visit.lower[i] <= limit_[i])) continue;
        if (mailboxes_[i].is_first_visit(id)) {
          searches_[i]->test(id);
        } else {
          ++counters_.mailbox;
        }
      }
    }
    for (std::size_t i = 0; i < lanes; ++i) limit_[i] = searches_[i]->limit();
  }

  const KdArrays& tree_;
  CastCounters& counters_;
  std::array<std::optional<PreparedRay>, lanes> prepared_;
  std::array<std::optional<Search>, lanes> searches_;
  std::array<Mailboxes, lanes> mailboxes_;
  std::array<Lanes, 3> ahead_, behind_, inverse_;
  Lanes limit_;
  Visit root_;
};

}  // namespace

void first_hits(const KdTree& tree, std::span<const Ray> rays, const Interval& range, CastCounters& counters,
                std::span<RayHit> out, const HitFilter& filter) {
  VELUM_REQUIRE(out.size() == rays.size(), {"out.size()", out.size()}, {"rays.size()", rays.size()});
  const bool can_share = !tree.nodes().empty() && tree.arrays().reaches.empty();
  for (std::size_t first = 0; first < rays.size(); first += lanes) {
    const std::span<const Ray> some = rays.subspan(first, std::min(lanes, rays.size() - first));
    std::optional<Packet> packet;
    if (can_share && some.size() == lanes) packet.emplace(tree, some, range, filter, counters);
    const bool together = packet && packet->is_coherent();
    if (together) packet->walk();
    for (std::size_t i = 0; i < some.size(); ++i) {
      out[first + i] = together ? packet->hit(i) : tree.first_hit(some[i], range, counters, filter);
      if (together) counters.hits += out[first + i].is_hit();
    }
  }
}

}  // namespace velum
