// The surface-area heuristic over a few divisions only.
#include <algorithm>
#include <array>
#include <limits>

#include "bvh_build.hpp"

namespace velum {
namespace {

constexpr int bin_count = 16;

struct Bin {
  Box box;
  std::uint32_t count = 0;
};

/// The bins along one axis, over the items' centres.
struct Binning {
  int axis;
  float lower, scale;

  int operator()(const BoxedItem& item) const {
    const int bin = static_cast<int>((item.centre(axis) - lower) * scale);
    return std::clamp(bin, 0, bin_count - 1);
  }
};

struct Division {
  double cost = std::numeric_limits<double>::infinity();
  int last_left = 0;  ///< the last bin that goes left
  Binning binning{};
};

void find_cheapest(const std::array<Bin, bin_count>& bins, const Binning& binning, Division& best) {
  std::array<double, bin_count> right{};
  Box box;
  std::uint32_t count = 0;
  for (int i = bin_count - 1; i > 0; --i) {
    const auto k = static_cast<std::size_t>(i);
    box.include(bins[k].box);
    count += bins[k].count;
    right[k] = box.half_area() * count;
  }
  box = {};
  const std::uint32_t all = count + bins[0].count;
  count = 0;
  for (int i = 0; i + 1 < bin_count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    box.include(bins[k].box);
    count += bins[k].count;
    const double cost = box.half_area() * count + right[k + 1];
    if (count != 0 && count != all && cost < best.cost) best = {cost, i, binning};
  }
}

}  // namespace

std::size_t split_by_bins(const BvhTask& task, const BvhSettings& settings) {
  Box centres;
  for (const BoxedItem& item : task.items) centres.include({item.centre(0), item.centre(1), item.centre(2)});
  Division best;
  for (int axis = 0; axis < 3; ++axis) {
    const float size = centres.upper[axis] - centres.lower[axis];
    // The scale of a size that is denormal, or infinite, is none.
    if (!(size > 1e-30f && size < 1e30f)) continue;
    const Binning binning{axis, centres.lower[axis], static_cast<float>(bin_count) / size};
    std::array<Bin, bin_count> bins;
    for (const BoxedItem& item : task.items) {
      Bin& bin = bins[static_cast<std::size_t>(binning(item))];
      bin.box.include(item.box);
      ++bin.count;
    }
    find_cheapest(bins, binning, best);
  }
  const double as_leaf = static_cast<double>(task.items.size()) * settings.triangle_cost;
  const double divided = settings.box_cost + best.cost / task.box.half_area() * settings.triangle_cost;
  if (!(divided <= as_leaf)) return 0;
  const auto right =
      std::stable_partition(task.items.begin(), task.items.end(),
                            [&best](const BoxedItem& item) { return best.binning(item) <= best.last_left; });
  return static_cast<std::size_t>(right - task.items.begin());
}

}  // namespace velum
