#include "occlusion.hpp"

#include <string>

#include "../base/error.hpp"
#include "../visibility/box_projection.hpp"
#include "../visibility/z_pyramid.hpp"
#include "check_request.hpp"
#include "render.hpp"

namespace velum {
namespace {

/// The chosen instances alone.
Scene occluders_of(const Scene& scene, std::span<const std::uint32_t> instances) {
  Scene chosen;
  std::vector<std::uint32_t> mesh_in_chosen(scene.meshes().size(), 0xFFFFFFFFu);
  for (const std::uint32_t i : instances) {
    if (i >= scene.instances().size()) {
      throw Error(ErrorKind::usage, "the scene has no instance " + std::to_string(i), "instances",
                  "give numbers below " + std::to_string(scene.instances().size()));
    }
    const Instance& instance = scene.instances()[i];
    std::uint32_t& mesh = mesh_in_chosen[instance.mesh];
    if (mesh == 0xFFFFFFFFu) {
      Mesh surface = scene.meshes()[instance.mesh];
      surface.segments = {};  // too thin to hide anything
      surface.points = {};
      mesh = chosen.add_mesh(std::move(surface));
    }
    Instance copy;
    copy.mesh = mesh;
    copy.world_from_object = instance.world_from_object;
    chosen.add_instance(copy);
  }
  return chosen;
}

std::vector<std::uint32_t> all_of(const Scene& scene) {
  std::vector<std::uint32_t> all(scene.instances().size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

/// r = 1 - z as the buffer had it: the picture's depth is z.
RenderSettings settings_for(int width, int height) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.shading = Shading::triangle_id;
  return settings;
}

}  // namespace

struct OcclusionBuffer::Contents {
  Image<float> reversed_depth;
  ZPyramid pyramid;
  ViewingTransform viewing;
  Viewport viewport;
};

OcclusionBuffer::OcclusionBuffer(const Scene& scene, const Camera& camera, int width, int height,
                                 std::span<const std::uint32_t> instances)
    : contents_(std::make_unique<Contents>()) {
  const RenderSettings settings = settings_for(width, height);
  contents_->viewing = requested_view(camera, settings);
  contents_->viewport = {width, height};
  const Scene occluders =
      occluders_of(scene, instances.empty() ? all_of(scene)
                                            : std::vector<std::uint32_t>(instances.begin(), instances.end()));
  Image<float> depth(width, height);
  Renderer().render_into(occluders, camera, settings, {.depth = depth.view()});
  // The picture's z is 1 - r, rounded: one step farther is on the safe side.
  contents_->reversed_depth.resize(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float r = 1.0f - depth.at(x, y) - 0x1p-23f;
      contents_->reversed_depth.at(x, y) = r > 0.0f ? r : 0.0f;
    }
  }
  contents_->pyramid.build(contents_->reversed_depth);
}

OcclusionBuffer::~OcclusionBuffer() = default;
OcclusionBuffer::OcclusionBuffer(OcclusionBuffer&&) noexcept = default;
OcclusionBuffer& OcclusionBuffer::operator=(OcclusionBuffer&&) noexcept = default;

bool OcclusionBuffer::is_hidden(const Aabb& box) const {
  const glm::dvec3 &low = box.lower, &high = box.upper;
  if (low.x > high.x || low.y > high.y || low.z > high.z) return true;
  const BoxProjection projection(contents_->viewing, contents_->viewport, box);
  const BoxOnPicture bounds = projection(box);
  return bounds.is_outside || contents_->pyramid.is_hidden(bounds.pixels, bounds.nearest).is_hidden;
}

bool OcclusionBuffer::is_hidden(const Sphere& sphere) const {
  return is_hidden(Aabb{sphere.centre - sphere.radius, sphere.centre + sphere.radius});
}

std::vector<std::uint8_t> OcclusionBuffer::are_hidden(std::span<const Aabb> boxes) const {
  std::vector<std::uint8_t> answers;
  answers.reserve(boxes.size());
  for (const Aabb& box : boxes) answers.push_back(is_hidden(box) ? 1 : 0);
  return answers;
}

}  // namespace velum
