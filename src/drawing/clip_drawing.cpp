#include "clip_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <vector>

#include "../base/contract.hpp"
#include "../base/floating_point.hpp"
#include "../projection/frame.hpp"
#include "../projection/viewport.hpp"
#include "canvas.hpp"

namespace velum {
namespace {

constexpr Rgba8 paper{255, 255, 255, 255};
constexpr Rgba8 ink{20, 20, 20, 255};
constexpr Rgba8 faint{150, 150, 150, 255};
constexpr Rgba8 outline_colour{120, 120, 200, 255};
constexpr Rgba8 made_colour{200, 0, 0, 255};
constexpr Rgba8 face_colour{255, 200, 60, 90};
/// One tint per step, the triangle itself first.
constexpr Rgba8 tints[] = {{90, 130, 230, 120}, {60, 170, 170, 130}, {70, 170, 80, 130}, {150, 170, 50, 130},
                           {220, 150, 40, 130}, {220, 100, 60, 130}, {190, 80, 150, 130}};

/// Half the volume's depth is drawn as long as half its width, so that the box is no flat slab.
constexpr double depth_stretch = 2.0;
/// Vertices farther out than this do not make the box smaller; their edges leave the panel.
constexpr double farthest_shown = 2.5;
/// Free above the volume, for two lines of text; pixels.
constexpr int header = 40;

glm::dvec3 model_of(const glm::dvec3& canonical) {
  return {canonical.x, canonical.y, -depth_stretch * canonical.z};
}

glm::dvec3 divided(const glm::dvec4& v) {
  return {v.x / v.w, v.y / v.w, v.z / v.w};
}

/// The part of a polygon in front of the eye: w ≥ a small share of the largest w.
std::vector<glm::dvec4> in_front(const std::vector<glm::dvec4>& polygon) {
  double largest = 0.0;
  for (const glm::dvec4& v : polygon) largest = std::max(largest, v.w);
  const double least = 0.02 * largest;
  std::vector<glm::dvec4> result;
  if (!(largest > 0.0)) return result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec4& a = polygon[i];
    const glm::dvec4& b = polygon[(i + 1) % polygon.size()];
    if (a.w >= least) result.push_back(a);
    if ((a.w >= least) != (b.w >= least)) result.push_back(a + (b - a) * ((least - a.w) / (b.w - a.w)));
  }
  return result;
}

/// The camera that looks at the volume from outside.
class Outside {
 public:
  Outside(const ClipTrace& trace, int size) : viewport_{size, size - header} {
    Aabb bounds;
    bounds.include(model_of({-1, -1, 0}));
    bounds.include(model_of({1, 1, 1}));
    for (const TracedVertex& vertex : trace.vertices) {
      if (!(vertex.position.w > 0.0)) continue;
      const glm::dvec3 canonical = divided(vertex.position);
      bounds.include(model_of(glm::clamp(canonical, glm::dvec3(-farthest_shown, -farthest_shown, -1.0),
                                         glm::dvec3(farthest_shown, farthest_shown, 2.0))));
    }
    FrameOptions options;
    options.margin = 0.09;
    options.aspect = static_cast<double>(viewport_.width) / viewport_.height;
    const Camera camera = frame(bounds, projection::orthographic(radians(22.0), radians(-32.0)), options);
    picture_from_model_ = camera.viewing_transform(options.aspect).clip_from_world();
  }

  /// Panel position of a canonical point.
  glm::dvec2 at(const glm::dvec3& canonical) const {
    const glm::dvec4 clip = picture_from_model_ * glm::dvec4(model_of(canonical), 1.0);
    return viewport_.pixel_from_ndc(clip.x, clip.y) + glm::dvec2(0, header);
  }

 private:
  Viewport viewport_;
  glm::dmat4 picture_from_model_{1.0};
};

/// Bit 0, 1, 2: right, above, behind.
glm::dvec3 box_corner(unsigned i) {
  return {(i & 1u) ? 1.0 : -1.0, (i & 2u) ? 1.0 : -1.0, (i & 4u) ? 1.0 : 0.0};
}

/// The corners of a plane's face in order around it.
std::vector<glm::dvec3> face_of(ClipPlane plane) {
  const ClipPlaneRow& row = clip_planes[static_cast<std::size_t>(plane)];
  const unsigned fixed = 1u << row.axis;
  const unsigned value = row.bound > 0.0 ? fixed : 0u;
  const unsigned first = fixed == 1u ? 2u : 1u;
  const unsigned second = fixed == 4u ? 2u : 4u;
  return {box_corner(value), box_corner(value | first), box_corner(value | first | second),
          box_corner(value | second)};
}

class Panel {
 public:
  Panel(const ClipTrace& trace, const Outside& outside, int size)
      : trace_(trace), outside_(outside), canvas_(size, size, paper) {}

  Image<Rgba8> picture() const { return canvas_.picture(); }

  void draw_title(const std::string& title, const std::string& second) {
    canvas_.text({10, 8}, title, 2, ink);
    canvas_.text({10, 28}, second, 1, ink);
  }

  /// Edges that meet the corner farthest from the viewer are hidden: dashed. The viewer stands to the front
  /// left above.
  void draw_box() {
    constexpr unsigned hidden = 1u | 4u;
    for (unsigned i = 0; i < 8; ++i) {
      for (unsigned axis = 0; axis < 3; ++axis) {
        const unsigned j = i | 1u << axis;
        if (j == i) continue;
        const glm::dvec2 a = at(box_corner(i));
        const glm::dvec2 b = at(box_corner(j));
        if (i == hidden || j == hidden) {
          canvas_.dashed_line(a, b, 1.0, 4.0, faint);
        } else {
          canvas_.line(a, b, 1.5, ink);
        }
      }
    }
    canvas_.text(at({0, -1, 0}) + glm::dvec2(0, 6), "near z=0", 1, faint, TextAnchor::middle);
    canvas_.text(at({0.7, 1, 1}) + glm::dvec2(8, -12), "far z=1", 1, faint, TextAnchor::left);
  }

  void draw_face(ClipPlane plane) { canvas_.polygon(corners_of(face_of(plane)), face_colour); }

  void draw_triangle() { canvas_.outline(visible({0, 1, 2}), 1.0, outline_colour); }

  void draw_polygon(const std::vector<int>& numbers, const Rgba8& tint) {
    const std::vector<glm::dvec2> corners = visible(numbers);
    canvas_.polygon(corners, tint);
    Rgba8 edge = tint;
    edge.a = 255;
    if (corners.size() > 1) canvas_.outline(corners, 2.0, edge);
  }

  /// Labels stand on the side away from this polygon's middle.
  void keep_labels_out_of(const std::vector<int>& numbers) {
    const std::vector<glm::dvec2> corners = visible(numbers);
    if (corners.empty()) return;
    middle_ = glm::dvec2(0.0);
    for (const glm::dvec2& corner : corners) middle_ += corner / static_cast<double>(corners.size());
  }

  void draw_vertices(const std::vector<int>& numbers, const Rgba8& colour) {
    for (const int number : numbers) {
      if (const auto p = place(number)) {
        canvas_.disc(*p, 4.0, colour);
        label(*p, number, colour);
      }
    }
  }

  void draw_removed(const std::vector<int>& numbers) {
    for (const int number : numbers) {
      if (const auto p = place(number)) {
        canvas_.ring(*p, 4.0, 1.5, faint);
        label(*p, number, faint);
      }
    }
  }

 private:
  glm::dvec2 at(const glm::dvec3& canonical) const { return outside_.at(canonical); }

  std::vector<glm::dvec2> corners_of(const std::vector<glm::dvec3>& canonical) const {
    std::vector<glm::dvec2> corners;
    for (const glm::dvec3& point : canonical) corners.push_back(at(point));
    return corners;
  }

  const glm::dvec4& position(int number) const {
    return trace_.vertices[static_cast<std::size_t>(number)].position;
  }

  std::vector<glm::dvec2> visible(const std::vector<int>& numbers) const {
    std::vector<glm::dvec4> polygon;
    for (const int number : numbers) polygon.push_back(position(number));
    std::vector<glm::dvec2> corners;
    for (const glm::dvec4& v : in_front(polygon)) corners.push_back(at(divided(v)));
    return corners;
  }

  std::optional<glm::dvec2> place(int number) const {
    if (!(position(number).w > 0.0)) return std::nullopt;
    return at(divided(position(number)));
  }

  /// With a rim of paper, so that it can be read over lines.
  void label(const glm::dvec2& p, int number, const Rgba8& colour) {
    const glm::dvec2 away = p - middle_;
    const double length = std::sqrt(glm::dot(away, away));
    const glm::dvec2 centre = p + (length > 0.0 ? away * (15.0 / length) : glm::dvec2(0.0, -15.0));
    const glm::dvec2 top = centre - glm::dvec2(0.0, 7.0);
    const std::string text = std::to_string(number);
    for (const glm::dvec2& rim : {glm::dvec2(-1, 0), glm::dvec2(1, 0), glm::dvec2(0, -1), glm::dvec2(0, 1)}) {
      canvas_.text(top + rim, text, 2, paper, TextAnchor::middle);
    }
    canvas_.text(top, text, 2, colour, TextAnchor::middle);
  }

  const ClipTrace& trace_;
  const Outside& outside_;
  Canvas canvas_;
  glm::dvec2 middle_{0.0};
};

const char* verdict_text(ClipVerdict verdict) {
  switch (verdict) {
    case ClipVerdict::accepted:
      return "inside all planes: accepted as it is";
    case ClipVerdict::rejected:
      return "all vertices outside of one plane: rejected";
    case ClipVerdict::clipped:
      return "partly inside: each plane takes its turn";
    case ClipVerdict::clipped_away:
      return "nothing will be left";
  }
  return "";
}

std::string numbers_text(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += (text.empty() ? "" : " ") + std::to_string(number);
  return text.empty() ? "nothing" : text;
}

bool has_vertex_behind(const ClipTrace& trace) {
  return std::any_of(trace.vertices.begin(), trace.vertices.end(),
                     [](const TracedVertex& v) { return !(v.position.w > 0.0); });
}

void draw_start(Panel& panel, const ClipTrace& trace) {
  panel.draw_box();
  panel.draw_polygon({0, 1, 2}, tints[0]);
  panel.keep_labels_out_of({0, 1, 2});
  panel.draw_vertices({0, 1, 2}, ink);
  panel.draw_title("triangle", has_vertex_behind(trace)
                                   ? "a vertex is behind the eye (w <= 0): drawn as far as it is in front"
                                   : verdict_text(trace.verdict));
}

void draw_step(Panel& panel, const ClipStep& step) {
  const auto index = static_cast<std::size_t>(step.plane);
  panel.draw_face(step.plane);
  panel.draw_box();
  panel.draw_triangle();
  panel.draw_polygon(step.polygon, tints[index + 1]);
  std::vector<int> kept;
  for (const int number : step.polygon) {
    if (std::find(step.made.begin(), step.made.end(), number) == step.made.end()) kept.push_back(number);
  }
  panel.keep_labels_out_of(step.polygon);
  panel.draw_removed(step.removed);
  panel.draw_vertices(kept, ink);
  panel.draw_vertices(step.made, made_colour);
  panel.draw_title("plane " + std::to_string(index) + ": " + clip_planes[index].name,
                   "cuts off " + numbers_text(step.removed) + ", left: " + numbers_text(step.polygon));
}

void copy_into(Image<Rgba8>& sheet, const Image<Rgba8>& panel, int left, int top) {
  for (int y = 0; y < panel.height(); ++y) {
    std::copy_n(panel.row(y), panel.width(), sheet.row(top + y) + left);
  }
}

}  // namespace

Image<Rgba8> draw_clipping(const ClipTrace& trace, int panel_size) {
  const FloatingPointScope floating_point;
  VELUM_REQUIRE(panel_size >= 120 && panel_size <= 2000, {"panel_size", panel_size});
  std::vector<const ClipStep*> cutting;
  for (const ClipStep& step : trace.steps) {
    if (step.cuts) cutting.push_back(&step);
  }
  const int panels = static_cast<int>(cutting.size()) + 1;
  const int columns = panels <= 3 ? panels : (panels == 4 ? 2 : 3);
  const int rows = (panels + columns - 1) / columns;
  Image<Rgba8> sheet(columns * panel_size, rows * panel_size, paper);
  const Outside outside(trace, panel_size);
  for (int i = 0; i < panels; ++i) {
    Panel panel(trace, outside, panel_size);
    if (i == 0) {
      draw_start(panel, trace);
    } else {
      draw_step(panel, *cutting[static_cast<std::size_t>(i - 1)]);
    }
    copy_into(sheet, panel.picture(), i % columns * panel_size, i / columns * panel_size);
  }
  return sheet;
}

}  // namespace velum
