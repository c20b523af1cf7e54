#include "octree_drawing.hpp"

#include <array>
#include <functional>
#include <string>

#include "../pipeline/check_request.hpp"
#include "../pipeline/hierarchical_stage.hpp"
#include "../projection/frame.hpp"
#include "box_view.hpp"

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

std::array<glm::dvec4, 8> volume_of(const ViewingTransform& viewing) {
  std::array<glm::dvec4, 8> corners =
      placed_corners({{-1.0, -1.0, 0.0}, {1.0, 1.0, 1.0}}, viewing.world_from_clip());
  for (glm::dvec4& corner : corners) corner /= corner.w;
  return corners;
}

/// Looks at the scene and the viewer from the side and above.
Camera second_camera(const Scene& scene, const std::array<glm::dvec4, 8>& volume, double aspect) {
  Aabb all = scene.bounds();
  for (std::size_t i = 0; i < 4; ++i) all.include(glm::dvec3(volume[i]));  // the near plane's corners
  FrameOptions options;
  options.aspect = aspect;
  options.z_up = scene.up == UpAxis::z;
  return frame(all, projection::isometric(), options);
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

  const std::array<glm::dvec4, 8> volume = volume_of(viewing);
  const double aspect = static_cast<double>(width) / height;
  const Camera second = second_camera(scene, volume, aspect);
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
  view.edges(volume, 2.0, volume_colour);
  for (std::size_t i = 0; i < styles.size(); ++i) {
    const std::string text = std::string(styles[i].name) + ": " + std::to_string(counts[i]);
    view.canvas().text({10.0, 10.0 + 18.0 * static_cast<double>(i)}, text, 2, styles[i].colour);
  }
  view.canvas().text({10.0, 82.0}, "the view volume", 2, volume_colour);
  return view.canvas().picture();
}

}  // namespace velum
