#include "octree_drawing.hpp"

#include <array>
#include <functional>
#include <string>

#include "../pipeline/check_request.hpp"
#include "../pipeline/hierarchical_stage.hpp"
#include "box_view.hpp"
#include "outside_view.hpp"

namespace velum {
namespace {

struct FateStyle {
  const char* name;
  Rgba8 colour;
};
/// In the order of NodeFate.
constexpr std::array<FateStyle, 4> styles{{{"drawn", {30, 140, 60, 255}},
                                           {"outside the view volume", {150, 150, 150, 255}},
                                           {"hidden by the pyramid", {205, 40, 40, 255}},
                                           {"facing away", {235, 140, 20, 255}}}};
/// What is drawn last is seen best.
constexpr std::array<NodeFate, 4> drawing_order{NodeFate::outside, NodeFate::facing_away, NodeFate::drawn,
                                                NodeFate::hidden};
constexpr Rgba8 volume_colour{30, 70, 190, 255};

glm::dvec4 point(const glm::dvec3& p) {
  return {p, 1.0};
}

/// The volume's edges; dashed where it is cut off, and a little further; and the eye.
void draw_volume(const ShownVolume& volume, BoxView& view) {
  std::array<glm::dvec4, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) corners[i] = point(volume.corners[i]);
  if (!volume.is_cut) {
    view.edges(corners, 2.0, volume_colour);
  } else {
    for (std::size_t i = 0; i < 4; ++i) {
      view.line(corners[i], corners[i + 4], 2.0, volume_colour);
      view.dashed_line(corners[i + 4], point(volume.beyond(i)), 2.0, volume_colour);
      for (const std::size_t next : {i ^ 1u, i ^ 2u}) {
        if (next < i) continue;
        view.line(corners[i], corners[next], 2.0, volume_colour);
        view.dashed_line(corners[i + 4], corners[next + 4], 1.5, volume_colour);
      }
    }
  }
  if (!volume.eye) return;
  for (std::size_t i = 0; i < 4; ++i) view.line(point(*volume.eye), corners[i], 1.0, volume_colour);
  if (const auto eye = view.place(point(*volume.eye))) view.canvas().disc(*eye, 4.0, volume_colour);
}

/// As large as the picture allows; none in a small one, where it would cover everything.
void draw_legend(const std::array<int, 4>& counts, const std::optional<ShownVolume>& volume, Canvas& canvas) {
  const int scale = canvas.width() >= 1000 && canvas.height() >= 600  ? 2
                    : canvas.width() >= 480 && canvas.height() >= 300 ? 1
                                                                      : 0;
  if (scale == 0) return;
  const auto line = [&](std::size_t i, const std::string& text, const Rgba8& colour) {
    const int top = scale * (5 + 9 * static_cast<int>(i));
    canvas.rectangle(scale * 3, top - scale, Canvas::text_width(text, scale) + 4 * scale, 9 * scale,
                     {255, 255, 255, 225});
    canvas.text({scale * 5.0, static_cast<double>(top)}, text, scale, colour);
  };
  for (std::size_t i = 0; i < styles.size(); ++i) {
    line(i, std::string(styles[i].name) + ": " + std::to_string(counts[i]), styles[i].colour);
  }
  if (!volume) return;
  const std::string until = volume->is_cut ? ", up to the end of the scene" : "";
  const std::string from = volume->eye ? " and its eye" : "";
  line(styles.size(), "the view volume" + from + until, volume_colour);
}

}  // namespace

Image<Rgba8> draw_octree(const Scene& scene, const Camera& camera, const RenderSettings& settings, int width,
                         int height) {
  const Rect rect = requested_rect(settings);
  const ViewingTransform viewing = requested_view(camera, settings);
  Executor executor(1, ExecutorKind::serial);
  const std::function<void(double)> progress = [](double) {};
  HierarchicalBuffers buffers;
  VisibilityBuffer visibility(rect.width, rect.height);
  Counters counters;
  std::vector<NodeRecord> records;
  draw_hierarchically({scene, viewing, settings, rect, executor, progress}, false, buffers, visibility,
                      counters, &records);

  const std::optional<ShownVolume> volume = shown_volume(viewing, scene.bounds());
  const double aspect = static_cast<double>(width) / height;
  const glm::dvec3 up = scene.up == UpAxis::z ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
  const Camera second = outside_camera(scene.bounds(), volume, up, aspect);
  BoxView view(second.viewing_transform(aspect).clip_from_world(), width, height);
  std::array<int, 4> counts{};
  for (const NodeFate fate : drawing_order) {
    for (const NodeRecord& record : records) {
      if (record.fate != fate) continue;
      ++counts[static_cast<std::size_t>(fate)];
      const bool is_of_scene = record.instance == NodeRecord::of_scene;
      const Aabb& box =
          is_of_scene
              ? buffers.octrees.instances().nodes()[record.node].box
              : buffers.octrees.mesh(scene.instances()[record.instance].mesh).nodes()[record.node].box;
      const glm::dmat4 placement =
          is_of_scene ? glm::dmat4(1.0) : scene.instances()[record.instance].world_from_object;
      view.edges(placed_corners(box, placement), 1.0, styles[static_cast<std::size_t>(fate)].colour);
    }
  }
  if (volume) draw_volume(*volume, view);
  draw_legend(counts, volume, view.canvas());
  return view.canvas().picture();
}

}  // namespace velum
