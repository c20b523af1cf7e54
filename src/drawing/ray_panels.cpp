#include "ray_panels.hpp"

#include "../base/contract.hpp"

namespace velum {
namespace {

using Steps = std::vector<RayStep>;

/// One past the last step below `root`.
std::size_t end_of(const Steps& steps, std::size_t root) {
  std::size_t i = root + 1;
  while (i < steps.size() && steps[i].level > steps[root].level) ++i;
  return i;
}

/// The hit that is seen in the end; the number of steps if there is none.
std::size_t hit_of(const Steps& steps) {
  std::size_t hit = steps.size();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].outcome == RayStep::Outcome::nearest) hit = i;
  }
  return hit;
}

RayPanel panel_at(const Steps& steps, std::size_t root, int levels, int depth) {
  RayPanel panel{root, {}};
  for (std::size_t i = root; i < end_of(steps, root); ++i) {
    if (steps[i].level <= steps[root].level + levels && steps[i].level <= depth) panel.steps.push_back(i);
  }
  return panel;
}

/// The panels' roots, in the order of the steps.
std::vector<std::size_t> roots_of(const Steps& steps, int levels, int depth) {
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool goes_on = i + 1 < steps.size() && steps[i + 1].level > steps[i].level;
    if (steps[i].level % levels == 0 && steps[i].level < depth && (goes_on || i == 0)) roots.push_back(i);
  }
  return roots;
}

}  // namespace

std::vector<RayPanel> ray_panels(const Steps& steps, int levels, int depth, std::size_t most) {
  VELUM_REQUIRE(levels >= 1 && most >= 1, {"levels", levels}, {"most", most});
  std::vector<std::size_t> roots = roots_of(steps, levels, depth);
  const std::size_t hit = hit_of(steps);
  for (std::size_t i = roots.size(); i-- > 0 && roots.size() > most;) {
    const bool leads_there = roots[i] < hit && hit < end_of(steps, roots[i]);
    if (!leads_there) roots.erase(roots.begin() + static_cast<std::ptrdiff_t>(i));
  }
  if (roots.size() > most) roots.resize(most);
  std::vector<RayPanel> panels;
  for (const std::size_t root : roots) panels.push_back(panel_at(steps, root, levels, depth));
  return panels;
}

}  // namespace velum
