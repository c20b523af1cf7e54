// Dividing planes from samples of the counts.
#include <algorithm>

#include "kd_split.hpp"

namespace velum {
namespace {

/// How many items begin before a place and how many end after it.
struct Sample {
  double place;
  double left = 0.0, right = 0.0;

  /// Ascends along the axis, from -n to n.
  double balance() const { return left - right; }
};

/// One axis of a cell with its samples, in ascending order; the first and last are the cell's sides.
class SampledAxis {
 public:
  SampledAxis(const std::vector<BoxedItem>& items, std::span<const std::uint32_t> inside, const Box& cell,
              int axis)
      : items_(items),
        inside_(inside),
        axis_(axis),
        lower_(static_cast<double>(cell.lower[axis])),
        upper_(static_cast<double>(cell.upper[axis])) {}

  void sample(int count) {
    const int even = std::max(count / 2, 1), adaptive = std::max(count - even, 0);
    std::vector<float> places;
    const auto add = [&places](double place) { places.push_back(static_cast<float>(place)); };
    for (int i = 1; i <= even; ++i) add(lower_ + (upper_ - lower_) * i / (even + 1));
    take(places);
    for (int i = 1; i <= adaptive; ++i) add(place_of_balance(total() * (2.0 * i / (adaptive + 1) - 1.0)));
    std::sort(places.begin(), places.end());
    if (adaptive > 0) take(places);
  }

  void find_best(const KdCost& cost, KdPlane& best) const {
    for (std::size_t i = 1; i < samples_.size(); ++i) {
      const Sample &from = samples_[i - 1], &to = samples_[i];
      consider(to, cost, best);
      const Sample middle{(from.place + to.place) * 0.5, (from.left + to.left) * 0.5,
                          (from.right + to.right) * 0.5};
      // Through the cost at 0, 1/2, 1 goes a parabola; its least is where its slope is 0.
      const double f0 = value(from, cost), f1 = value(middle, cost), f2 = value(to, cost);
      const double curvature = f0 - 2.0 * f1 + f2;
      if (!(curvature > 0.0)) continue;
      const double share = 0.5 - 0.25 * (f2 - f0) / curvature;
      if (share > 0.0 && share < 1.0) consider(between(from, to, share), cost, best);
    }
  }

 private:
  double total() const { return static_cast<double>(inside_.size()); }

  /// Without the bonus, which jumps.
  static double value(const Sample& s, const KdCost& cost) {
    return cost.without_bonus(s.place, s.left, s.right);
  }

  static Sample between(const Sample& a, const Sample& b, double share) {
    return {a.place + (b.place - a.place) * share, a.left + (b.left - a.left) * share,
            a.right + (b.right - a.right) * share};
  }

  void consider(const Sample& s, const KdCost& cost, KdPlane& best) const {
    const auto place = static_cast<float>(s.place);
    if (!(static_cast<double>(place) > lower_ && static_cast<double>(place) < upper_)) return;
    const double c = cost(s.place, s.left, s.right);
    if (c < best.cost) best = {c, axis_, place};
  }

  /// Counts at ascending places. Two histograms, one of beginnings and one of ends, then their sums.
  void take(const std::vector<float>& places) {
    const std::size_t count = places.size();
    std::vector<std::uint32_t> begins(count + 1, 0), ends(count + 1, 0);
    for (const std::uint32_t i : inside_) {
      const float lower = items_[i].box.lower[axis_], upper = items_[i].box.upper[axis_];
      std::uint32_t before_begin = 0, before_end = 0;  // by all comparisons: no branch to guess
      for (std::size_t k = 0; k < count; ++k) {
        before_begin += places[k] <= lower;
        before_end += places[k] < upper;
      }
      ++begins[before_begin];
      ++ends[before_end];
    }
    samples_.assign(1, {lower_, 0.0, total()});
    std::uint32_t begun = 0, ended = 0;
    for (std::size_t i = 0; i < count; ++i) {
      begun += begins[i];
      ended += ends[i];
      samples_.push_back({static_cast<double>(places[i]), static_cast<double>(begun), total() - ended});
    }
    samples_.push_back({upper_, total(), 0.0});
  }

  double place_of_balance(double balance) const {
    std::size_t i = 1;
    while (i + 1 < samples_.size() && samples_[i].balance() < balance) ++i;
    const Sample &from = samples_[i - 1], &to = samples_[i];
    const double rise = to.balance() - from.balance();
    const double share = rise > 0.0 ? (balance - from.balance()) / rise : 0.5;
    return between(from, to, std::clamp(share, 0.0, 1.0)).place;
  }

  const std::vector<BoxedItem>& items_;
  std::span<const std::uint32_t> inside_;
  int axis_;
  double lower_, upper_;
  std::vector<Sample> samples_;
};

}  // namespace

KdPlane sampled_plane(const std::vector<BoxedItem>& items, std::span<const std::uint32_t> inside,
                      const Box& cell, const KdSettings& settings) {
  KdPlane best;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(cell.lower[axis] < cell.upper[axis])) continue;
    SampledAxis sampled(items, inside, cell, axis);
    sampled.sample(settings.samples);
    sampled.find_best(KdCost(settings, cell, axis), best);
  }
  return best;
}

}  // namespace velum
