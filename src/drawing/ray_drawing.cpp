#include "ray_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "../base/floating_point.hpp"
#include "../image/visibility_buffer.hpp"
#include "../pipeline/render.hpp"
#include "../projection/frame.hpp"
#include "box_view.hpp"
#include "ray_panels.hpp"

namespace velum {
namespace {

constexpr int view_side = 420;   // of the square picture in a panel
constexpr int list_width = 360;  // of the steps beside it
constexpr int gap = 14;
constexpr int head = 30;
constexpr int line_height = 13;
constexpr int panel_width = view_side + list_width + gap;
constexpr int panel_height = view_side + head + gap;
constexpr int columns = 2;
constexpr int legend_height = 64;

constexpr Rgba8 paper{255, 255, 255, 255};
constexpr Rgba8 ink{20, 20, 20, 255};
constexpr Rgba8 ray_colour{30, 70, 200, 255};
constexpr Rgba8 hit_colour{205, 20, 20, 255};
constexpr Rgba8 entered_colour{20, 130, 60, 255};
constexpr Rgba8 missed_colour{135, 135, 135, 255};
constexpr Rgba8 left_out_colour{225, 125, 10, 255};

using Outcome = RayStep::Outcome;

Rgba8 colour_of(const RayStep& step) {
  switch (step.outcome) {
    case Outcome::entered:
      return entered_colour;
    case Outcome::beyond_hit:
    case Outcome::not_wanted:
      return left_out_colour;
    case Outcome::nearest:
    case Outcome::farther:
      return hit_colour;
    case Outcome::missed:
    case Outcome::culled:
      break;
  }
  return missed_colour;
}

std::string list_text(const RayStep& step, std::size_t number) {
  const char* kind = step.kind == RayStep::Kind::triangle   ? "triangle "
                     : step.kind == RayStep::Kind::instance ? "instance "
                     : step.is_leaf                         ? "leaf "
                                                            : "box ";
  return std::to_string(number) + "  " + kind + std::to_string(step.index) + ": " + reason_of(step);
}

/// What the panels have in common.
class RaySheet {
 public:
  RaySheet(const Scene& scene, const RayExplanation& ray) : scene_(scene), ray_(ray) {
    std::uint32_t instance = 0;
    for (const RayStep& step : ray.traversal) {
      if (step.kind == RayStep::Kind::instance) instance = step.index;
      const bool is_of_scene = instances_.empty() || step.level < level_of_instances_;
      if (step.kind == RayStep::Kind::instance)
        level_of_instances_ = std::min(level_of_instances_, step.level);
      instances_.push_back(is_of_scene && step.kind == RayStep::Kind::box ? of_scene : instance);
    }
    find_side();
  }

  Image<Rgba8> panel(const RayPanel& panel) const;

 private:
  static constexpr std::uint32_t of_scene = 0xFFFFFFFFu;

  /// Across the ray, a little from above and behind, so that the ray runs from left to right.
  void find_side() {
    const glm::dvec3 along = glm::normalize(ray_.ray.ray.direction);
    glm::dvec3 up = scene_.up == UpAxis::z ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    if (std::fabs(glm::dot(along, up)) > 0.9) up = glm::dvec3(up.y, up.z, up.x);
    towards_viewer_ = glm::normalize(glm::cross(along, up)) + up * 0.3 - along * 0.25;
    up_ = up;
  }

  std::array<glm::dvec4, 8> corners(std::size_t step) const {
    const RayStep& box = ray_.traversal[step];
    const glm::dmat4 placement = instances_[step] == of_scene
                                     ? glm::dmat4(1.0)
                                     : scene_.instances()[instances_[step]].world_from_object;
    return placed_corners({glm::dvec3(box.box.lower), glm::dvec3(box.box.upper)}, placement);
  }

  /// Sees the panel's outermost box from the side; near and far are just around it.
  Camera camera(const RayPanel& panel) const {
    std::vector<glm::dvec3> points;
    for (const glm::dvec4& corner : corners(box_of(panel))) points.emplace_back(corner);
    FrameOptions options;
    options.margin = 0.09;
    options.target = (points[0] + points[7]) * 0.5;
    options.eye = *options.target + towards_viewer_;
    options.up = up_;
    return frame(points, projection::front(), options);
  }
  /// An instance has no box of its own: the one that holds it.
  std::size_t box_of(const RayPanel& panel) const {
    std::size_t step = panel.root;
    while (step > 0 && ray_.traversal[step].kind != RayStep::Kind::box) --step;
    return step;
  }

  void draw_scene(BoxView& view, const Camera& camera) const;
  void draw_boxes(BoxView& view, const RayPanel& panel) const;
  void draw_numbers(BoxView& view, const RayPanel& panel) const;
  void draw_triangle(BoxView& view, std::size_t step) const;
  void draw_ray(BoxView& view) const;
  void draw_list(Canvas& canvas, const RayPanel& panel) const;

  const Scene& scene_;
  const RayExplanation& ray_;
  std::vector<std::uint32_t> instances_;  ///< of each step, in whose object space its box is
  int level_of_instances_ = std::numeric_limits<int>::max();
  glm::dvec3 towards_viewer_{0.0};
  glm::dvec3 up_{0.0};
};

void RaySheet::draw_scene(BoxView& view, const Camera& camera) const {
  RenderSettings settings;
  settings.width = settings.height = view_side;
  settings.shading = Shading::flat;
  const Picture picture = render(scene_, camera, settings);
  for (int y = 0; y < view_side; ++y) {
    for (int x = 0; x < view_side; ++x) {
      if (picture.triangle_id.at(x, y) == no_primitive) continue;
      Rgba8 colour = picture.colour.at(x, y);
      colour.a = 110;
      view.canvas().rectangle(x, y, 1, 1, colour);
    }
  }
}

void RaySheet::draw_triangle(BoxView& view, std::size_t step) const {
  const RayStep& triangle = ray_.traversal[step];
  const PrimitivePlace place = scene_.place(triangle.index);
  const Instance& instance = scene_.instances()[place.instance];
  const Mesh& mesh = scene_.meshes()[instance.mesh];
  std::array<glm::dvec4, 3> corners;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 p(mesh.positions[mesh.triangles[place.index][i]]);
    corners[static_cast<std::size_t>(i)] = instance.world_from_object * glm::dvec4(p, 1.0);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    view.line(corners[i], corners[(i + 1) % 3], 1.5, colour_of(triangle));
  }
}

void RaySheet::draw_boxes(BoxView& view, const RayPanel& panel) const {
  // What was entered is drawn last and is seen best; the innermost on top.
  for (const bool entered : {false, true}) {
    for (const std::size_t i : panel.steps) {
      const RayStep& step = ray_.traversal[i];
      if ((step.outcome == Outcome::entered) != entered) continue;
      if (step.kind == RayStep::Kind::triangle) draw_triangle(view, i);
      if (step.kind == RayStep::Kind::box) view.edges(corners(i), entered ? 1.6 : 1.0, colour_of(step));
    }
  }
  draw_numbers(view, panel);
}

/// At the corner farthest up; below those that stand there already.
void RaySheet::draw_numbers(BoxView& view, const RayPanel& panel) const {
  std::vector<glm::dvec2> taken;
  for (const std::size_t i : panel.steps) {
    const RayStep& step = ray_.traversal[i];
    if (step.kind != RayStep::Kind::box || i == panel.root) continue;
    glm::dvec2 corner(1e300);
    for (const glm::dvec4& world : corners(i)) {
      const auto at = view.place(world);
      if (at && at->y - at->x * 0.01 < corner.y - corner.x * 0.01) corner = *at;
    }
    const auto is_near = [&](const glm::dvec2& other) {
      return std::fabs(other.x - corner.x) < 20.0 && std::fabs(other.y - corner.y) < 9.0;
    };
    while (std::any_of(taken.begin(), taken.end(), is_near)) corner.y += 3.0;
    taken.push_back(corner);
    view.canvas().text(corner + glm::dvec2(2, 3), std::to_string(i), 1, colour_of(step));
  }
}

/// Drawn through up to the hit, dashed behind it.
void RaySheet::draw_ray(BoxView& view) const {
  const auto at = [&](double t) { return glm::dvec4(ray_.ray.ray.at(t), 1.0); };
  const double end = std::min(ray_.ray.range.upper, 1e6), start = std::max(ray_.ray.range.lower, -1e6);
  const double reached = ray_.hit.is_hit() ? ray_.hit.t : end;
  const auto from = view.place(at(start)), to = view.place(at(reached)), last = view.place(at(end));
  if (!from || !to || !last) return;
  view.canvas().line(*from, *to, 2.0, ray_colour);
  view.canvas().dashed_line(*to, *last, 1.0, 5.0, ray_colour);
  for (const SceneHit& hit : ray_.hits) {
    const auto place = view.place(at(hit.t));
    if (place) view.canvas().ring(*place, 3.5, 1.5, hit_colour);
  }
  if (ray_.hit.is_hit()) view.canvas().disc(*to, 3.5, hit_colour);
}

void RaySheet::draw_list(Canvas& canvas, const RayPanel& panel) const {
  int y = head;
  for (const std::size_t i : panel.steps) {
    const RayStep& step = ray_.traversal[i];
    if (y + 2 * line_height > head + view_side && i != panel.steps.back()) {
      canvas.text({view_side + gap, y}, "... and more", 1, ink);
      return;
    }
    const int indent = 8 * (step.level - ray_.traversal[panel.root].level);
    canvas.text({view_side + gap + indent, y}, list_text(step, i), 1, colour_of(step));
    y += line_height;
  }
}

Image<Rgba8> RaySheet::panel(const RayPanel& panel) const {
  const Camera side = camera(panel);
  BoxView view(side.viewing_transform(1.0).clip_from_world(), view_side, view_side);
  draw_scene(view, side);
  draw_boxes(view, panel);
  draw_ray(view);
  view.canvas().outline(std::array{glm::dvec2(0.5), glm::dvec2(view_side - 0.5, 0.5),
                                   glm::dvec2(view_side - 0.5), glm::dvec2(0.5, view_side - 0.5)},
                        1.0, missed_colour);
  Canvas canvas(panel_width, panel_height, paper);
  const int first = ray_.traversal[panel.root].level;
  canvas.text({0, 8},
              "steps " + std::to_string(panel.steps.front()) + " ... " + std::to_string(panel.steps.back()) +
                  ", from level " + std::to_string(first) + " down",
              2, ink);
  draw_list(canvas, panel);
  Image<Rgba8> picture = canvas.picture();
  const Image<Rgba8> seen = view.canvas().picture();
  for (int y = 0; y < view_side; ++y) std::copy_n(seen.row(y), view_side, picture.row(y + head));
  return picture;
}

Image<Rgba8> legend(const RayExplanation& ray) {
  Canvas canvas(columns * panel_width, legend_height, paper);
  const std::string pixel = std::to_string(ray.x) + "," + std::to_string(ray.y);
  canvas.text({0, 6},
              "The ray through pixel " + pixel + " and the boxes that it was tested against, in order", 2,
              ink);
  double x = 0.0;
  const auto entry = [&](const std::string& words, const Rgba8& colour) {
    canvas.text({x, 34}, words, 2, colour);
    x += Canvas::text_width(words, 2) + 28.0;
  };
  entry("the ray", ray_colour);
  entry("hit", hit_colour);
  entry("entered", entered_colour);
  entry("missed", missed_colour);
  entry("left out: not nearer than the hit", left_out_colour);
  return canvas.picture();
}

void paste(const Image<Rgba8>& part, int left, int top, Image<Rgba8>& whole) {
  for (int y = 0; y < part.height(); ++y) std::copy_n(part.row(y), part.width(), whole.row(top + y) + left);
}

}  // namespace

Image<Rgba8> draw_ray(const Scene& scene, const RayExplanation& ray, const RayDrawing& drawing) {
  const FloatingPointScope floating_point;
  const std::vector<RayPanel> panels =
      ray_panels(ray.traversal, drawing.levels, drawing.depth, static_cast<std::size_t>(drawing.most_panels));
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  Image<Rgba8> sheet(gap + columns * panel_width, legend_height + rows * panel_height, paper);
  paste(legend(ray), gap, 0, sheet);
  const RaySheet draws(scene, ray);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const int column = static_cast<int>(i) % columns, row = static_cast<int>(i) / columns;
    paste(draws.panel(panels[i]), gap + column * panel_width, legend_height + row * panel_height, sheet);
  }
  return sheet;
}

}  // namespace velum
