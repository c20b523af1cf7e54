#include "explain_ray.hpp"

#include <algorithm>

#include "../base/floating_point.hpp"
#include "../raycast/bvh/bvh.hpp"
#include "../raycast/intersection/watertight.hpp"
#include "check_request.hpp"
#include "ray_stage.hpp"

namespace velum {
namespace {

/// @pre the box is missed
SlabGap gap_of(const BvhNode& box, const PreparedRay& ray) {
  SlabGap gap{0, std::numeric_limits<double>::infinity(), 0, -std::numeric_limits<double>::infinity()};
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 lower(-std::numeric_limits<float>::infinity()), upper(-lower);
    lower[axis] = box.lower[axis];
    upper[axis] = box.upper[axis];
    const Interval slab = ray.through(lower, upper);
    if (slab.upper < gap.left) gap.left_axis = axis;
    if (slab.lower > gap.entered) gap.entered_axis = axis;
    gap.left = std::min(gap.left, slab.upper);
    gap.entered = std::max(gap.entered, slab.lower);
  }
  return gap;
}

/// Goes the way of BvhTree::traverse() on both levels, and writes it down.
class Recorder {
 public:
  Recorder(const SceneCaster& caster, const RayView& view, const ViewRay& ray)
      : caster_(caster), view_(view), ray_(ray) {}

  std::vector<RayStep> run() {
    if (caster_.top().nodes.empty()) return {};
    const PreparedRay prepared(ray_.ray, ray_.range, caster_.bounds());
    if (prepared.usable) {
      visit(caster_.top(), 0, prepared, 0, [this](std::uint32_t id, int level) { enter(id, level); });
    }
    return std::move(steps_);
  }

 private:
  Interval inside(const BvhTree& tree, std::uint32_t node, const PreparedRay& ray) const {
    return ray.through(tree.nodes[node].lower, tree.nodes[node].upper);
  }

  RayStep::Outcome outcome_of(const Interval& inside, const PreparedRay& ray) const {
    if (inside.is_empty()) return RayStep::Outcome::missed;
    if (intersect(inside, ray.range).is_empty()) return RayStep::Outcome::not_wanted;
    return inside.lower > nearest_ ? RayStep::Outcome::beyond_hit : RayStep::Outcome::entered;
  }

  template <typename Leaf>
  void visit(const BvhTree& tree, std::uint32_t index, const PreparedRay& ray, int level, const Leaf& leaf) {
    const BvhNode& node = tree.nodes[index];
    const Interval part = inside(tree, index, ray);
    const RayStep::Outcome outcome = outcome_of(part, ray);
    steps_.push_back(
        {RayStep::Kind::box, outcome, level, node.is_leaf(), index, {node.lower, node.upper}, part, {}});
    if (outcome == RayStep::Outcome::missed) steps_.back().gap = gap_of(node, ray);
    if (outcome != RayStep::Outcome::entered) return;
    if (node.is_leaf()) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) leaf(tree.order[i], level + 1);
      return;
    }
    const auto entry = [&](std::uint32_t child) {
      return std::max(inside(tree, child, ray).lower, ray.range.lower);
    };
    const bool right_first = entry(node.first + 1) < entry(node.first);
    visit(tree, node.first + (right_first ? 1u : 0u), ray, level + 1, leaf);
    visit(tree, node.first + (right_first ? 0u : 1u), ray, level + 1, leaf);
  }

  void enter(std::uint32_t instance, int level) {
    const auto& structure = static_cast<const Bvh&>(caster_.structure(caster_.mesh_of(instance)));
    const PreparedRay prepared(caster_.in_object(instance, ray_.ray), ray_.range, structure.bounds());
    steps_.push_back(
        {RayStep::Kind::instance, RayStep::Outcome::entered, level, false, instance, {}, {}, {}});
    if (!prepared.usable || structure.tree().nodes.empty()) return;
    visit(structure.tree(), 0, prepared, level + 1, [&](std::uint32_t triangle, int deeper) {
      const auto hit = intersect_watertight(prepared, structure.triangles()[triangle]);
      test(instance, triangle, hit ? &hit->t : nullptr, deeper);
    });
  }

  void test(std::uint32_t instance, std::uint32_t triangle, const double* t, int level) {
    const std::uint32_t primitive = caster_.primitive(instance, triangle);
    RayStep step{RayStep::Kind::triangle, RayStep::Outcome::missed, level, false, primitive, {}, {}, {}};
    if (t != nullptr) {
      step.inside = {*t, *t};
      step.outcome = outcome_of_hit(instance, triangle, *t, primitive);
    }
    steps_.push_back(step);
    if (step.outcome != RayStep::Outcome::nearest) return;
    nearest_ = *t;
    nearest_primitive_ = primitive;
  }

  RayStep::Outcome outcome_of_hit(std::uint32_t instance, std::uint32_t triangle, double t,
                                  std::uint32_t primitive) const {
    if (!ray_.range.contains(t)) return RayStep::Outcome::not_wanted;
    if (view_.is_culled(instance, triangle)) return RayStep::Outcome::culled;
    return is_before(t, primitive, nearest_, nearest_primitive_) ? RayStep::Outcome::nearest
                                                                 : RayStep::Outcome::farther;
  }

  const SceneCaster& caster_;
  const RayView& view_;
  ViewRay ray_;
  double nearest_ = std::numeric_limits<double>::infinity();
  std::uint32_t nearest_primitive_ = no_triangle;
  std::vector<RayStep> steps_;
};

}  // namespace

std::string reason_of(const RayStep& step) {
  constexpr const char* axes[] = {"x", "y", "z"};
  switch (step.outcome) {
    case RayStep::Outcome::entered:
      return "entered";
    case RayStep::Outcome::missed:
      if (step.kind != RayStep::Kind::box) return "missed";
      return std::string("missed: leaves ") + axes[step.gap.left_axis] + " before it enters " +
             axes[step.gap.entered_axis];
    case RayStep::Outcome::not_wanted:
      return "left out: not between near and far";
    case RayStep::Outcome::beyond_hit:
      return "left out: entered after the nearest hit";
    case RayStep::Outcome::nearest:
      return "hit, the nearest so far";
    case RayStep::Outcome::farther:
      return "hit, behind another";
    case RayStep::Outcome::culled:
      break;
  }
  return "hit, culled by its facing";
}

RayExplanation explain_ray(const Scene& scene, const Camera& camera, const RenderSettings& settings, int x,
                           int y) {
  const FloatingPointScope floating_point;
  check_pixel(requested_rect(settings), x, y);
  const ViewingTransform viewing = requested_view(camera, settings);
  const SceneCaster caster(scene, settings.accelerator);
  const RayView view(scene, caster, viewing, settings);
  RayExplanation result;
  result.x = x;
  result.y = y;
  result.ray = view.rays().through(x + 0.5, y + 0.5);
  result.hit = view.at(x + 0.5, y + 0.5, result.counters);
  CastCounters not_reported;
  caster.all_hits(result.ray.ray, result.ray.range, not_reported, result.hits, view.filter());
  if (settings.accelerator == AcceleratorKind::binary_bvh) {
    result.traversal = Recorder(caster, view, result.ray).run();
  } else {
    const SceneCaster by_boxes(scene, AcceleratorKind::binary_bvh);
    result.traversal = Recorder(by_boxes, view, result.ray).run();
  }
  return result;
}

}  // namespace velum
