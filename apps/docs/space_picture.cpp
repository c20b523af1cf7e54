// The house, the view volume and the triangle in the space after each stage, drawn from outside.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "blocks.hpp"
#include "paint.hpp"

namespace velum_docs {
namespace {

using namespace velum;

constexpr int panel_width = 300;
constexpr int panel_height = 240;
constexpr int caption = 30;

struct Line {
  glm::dvec4 a{0.0};
  glm::dvec4 b{0.0};
};

/// An edge with the normals of the triangles that meet in it, by positions.
struct Edge {
  glm::vec3 a{0.0f};
  glm::vec3 b{0.0f};
  glm::vec3 normal{0.0f};
};

bool joins_flatly(const Edge& e, const Edge& f) {
  const bool same = (e.a == f.b && e.b == f.a) || (e.a == f.a && e.b == f.b);
  return same && glm::dot(e.normal, f.normal) > 0.999f;
}

/// The mesh's edges without those between triangles of one plane.
std::vector<Line> feature_lines(const Mesh& mesh) {
  std::vector<Edge> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const glm::uvec3& indices = mesh.triangles[t];
    const glm::vec3 p[] = {mesh.positions[indices[0]], mesh.positions[indices[1]],
                           mesh.positions[indices[2]]};
    const glm::vec3 normal = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
    for (int i = 0; i < 3; ++i) edges.push_back({p[i], p[(i + 1) % 3], normal});
  }
  std::vector<Line> lines;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool flat = std::any_of(edges.begin(), edges.end(), [&](const Edge& other) {
      return &other != &edges[i] && joins_flatly(edges[i], other);
    });
    if (!flat) lines.push_back({glm::dvec4(edges[i].a, 1.0), glm::dvec4(edges[i].b, 1.0)});
  }
  return lines;
}

/// The twelve edges of the canonical volume, in world space.
std::vector<Line> volume_lines(const ViewingTransform& viewing) {
  const glm::dmat4 world_from_clip = viewing.world_from_clip();
  const auto corner = [&](unsigned i) {
    const glm::dvec4 p =
        world_from_clip * glm::dvec4((i & 1u) ? 1.0 : -1.0, (i & 2u) ? 1.0 : -1.0, (i & 4u) ? 1.0 : 0.0, 1.0);
    return p / p.w;
  };
  std::vector<Line> lines;
  for (unsigned i = 0; i < 8; ++i) {
    for (const unsigned bit : {1u, 2u, 4u}) {
      if ((i & bit) == 0) lines.push_back({corner(i), corner(i | bit)});
    }
  }
  return lines;
}

/// The space after `stage` stages: what is drawn in it, and the camera that looks at it from outside.
class Space {
 public:
  Space(const Subject& subject, std::size_t stage) : subject_(subject), stage_(stage) {
    house_ = feature_lines(subject.scene.meshes()[0]);
    volume_ = volume_lines(subject.viewing);
    std::vector<glm::dvec3> points{glm::dvec3(0.0)};
    for (const std::vector<Line>* lines : {&house_, &volume_}) {
      for (const Line& line : *lines) {
        points.push_back(place(line.a));
        points.push_back(place(line.b));
      }
    }
    if (stage_ == 0) points.push_back(subject.camera.pose().position);
    FrameOptions options;
    options.aspect = static_cast<double>(panel_width) / (panel_height - caption);
    options.margin = 0.06;
    // From the camera's right, whichever way the space is turned: its turning shows in the axes.
    const double azimuth = radians(stage_ < 2 ? 84.0 : 50.0);
    const Camera outside = frame(points, projection::orthographic(radians(24.0), azimuth), options);
    clip_from_space_ = outside.viewing_transform(options.aspect).clip_from_world();
  }

  Image<Rgba8> draw(const std::string& title) const {
    Canvas canvas(panel_width, panel_height, paper);
    draw_axes(canvas);
    for (const Line& line : volume_) canvas.line(at(line.a), at(line.b), 1.0, blue);
    for (const Line& line : house_) canvas.line(at(line.a), at(line.b), 1.0, faint);
    std::vector<glm::dvec2> corners;
    for (const VertexTrace& vertex : subject_.triangle.vertices) corners.push_back(at(vertex.images[0]));
    canvas.polygon(corners, with_alpha(red, 110));
    canvas.outline(corners, 1.5, red);
    if (stage_ == 0) {
      const glm::dvec2 eye = at(glm::dvec4(subject_.camera.pose().position, 1.0));
      canvas.disc(eye, 4.0, blue);
      canvas.text(eye + glm::dvec2(8, -3), "COP", 1, blue);
    }
    canvas.text({6, 6}, title, 2, ink);
    return canvas.picture();
  }

 private:
  glm::dvec3 place(const glm::dvec4& world) const {
    const glm::dvec4 p = subject_.viewing.images_of(world)[stage_];
    return {p.x / p.w, p.y / p.w, p.z / p.w};
  }

  glm::dvec2 on_panel(const glm::dvec3& p) const {
    const glm::dvec4 clip = clip_from_space_ * glm::dvec4(p, 1.0);
    return Viewport{panel_width, panel_height - caption}.pixel_from_ndc(clip.x, clip.y) +
           glm::dvec2(0, caption);
  }
  glm::dvec2 at(const glm::dvec4& world) const { return on_panel(place(world)); }

  /// One unit long.
  void draw_axes(Canvas& canvas) const {
    const glm::dvec2 origin = on_panel(glm::dvec3(0.0));
    constexpr const char* names[] = {"x", "y", "z"};
    constexpr Rgba8 colours[] = {red, green, blue};
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 end(0.0);
      end[axis] = 1.0;
      const glm::dvec2 tip = on_panel(end);
      canvas.dashed_line(origin, tip, 1.0, 3.0, colours[axis]);
      canvas.text(tip + glm::dvec2(4, -8), names[axis], 1, colours[axis]);
    }
  }

  const Subject& subject_;
  std::size_t stage_;
  std::vector<Line> house_;
  std::vector<Line> volume_;
  glm::dmat4 clip_from_space_{1.0};
};

}  // namespace

Image<Rgba8> draw_spaces(const Subject& subject) {
  constexpr int columns = 3;
  const StageList& stages = subject.viewing.stages();
  const int panels = static_cast<int>(stages.size()) + 1;
  const int rows = (panels + columns - 1) / columns;
  Image<Rgba8> sheet(columns * panel_width, rows * panel_height, paper);
  for (int i = 0; i < panels; ++i) {
    const auto stage = static_cast<std::size_t>(i);
    const Image<Rgba8> panel =
        Space(subject, stage).draw(i == 0 ? "world" : "after " + std::string(stages[stage - 1].name));
    for (int y = 0; y < panel_height; ++y) {
      std::copy_n(panel.row(y), panel_width,
                  sheet.row(i / columns * panel_height + y) + i % columns * panel_width);
    }
  }
  return sheet;
}

}  // namespace velum_docs
