#include "wireframe_stage.hpp"

#include <algorithm>

#include "../visibility/zbuffer.hpp"
#include "line_stages.hpp"

namespace velum {
namespace {

bool is_before(const glm::uvec2& a, const glm::uvec2& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

void append_edges(const glm::uvec3& triangle, std::vector<glm::uvec2>& edges) {
  for (glm::length_t i = 0; i < 3; ++i) {
    const std::uint32_t from = triangle[i];
    const std::uint32_t to = triangle[i == 2 ? 0 : i + 1];
    edges.emplace_back(std::min(from, to), std::max(from, to));
  }
}

float steepness(const DepthPlane& plane) {
  return std::max(plane.dx < 0.0f ? -plane.dx : plane.dx, plane.dy < 0.0f ? -plane.dy : plane.dy);
}

}  // namespace

void WireframeBuffers::draw_edges(const Scene& scene, std::uint32_t index, const glm::dmat4& clip_from_object,
                                  const RenderSettings& settings, const Rect& rect) {
  const Instance& instance = scene.instances()[index];
  const Mesh& mesh = scene.meshes()[instance.mesh];
  const bool mirrored = is_mirroring(instance.world_from_object);
  Counters uncounted;
  transform_vertices(mesh.positions.span(), clip_from_object, vertices);
  edges.clear();
  for (const glm::uvec3& triangle : mesh.triangles) {
    const TriangleFate fate = assemble(vertices, triangle, mirrored, settings.cull, {}, uncounted).fate;
    if (fate == TriangleFate::accepted || fate == TriangleFate::to_clip) append_edges(triangle, edges);
  }
  std::sort(edges.begin(), edges.end(), is_before);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  constexpr std::size_t batch_size = 4096;
  const Viewport viewport{settings.width, settings.height};
  for (std::size_t first = 0; first < edges.size(); first += batch_size) {
    screen_triangles.clear();
    for (std::size_t i = first; i < std::min(first + batch_size, edges.size()); ++i) {
      set_up_segment(vertices, edges[i], 0, settings.line_width, viewport, uncounted, screen_triangles);
    }
    move_all_to(sample, screen_triangles);
    rasterize_zbuffer(screen_triangles, {nearest, rect});
  }
}

void draw_wireframe(const Scene& scene, const ViewingTransform& viewing, const RenderSettings& settings,
                    const Rect& rect, WireframeBuffers& buffers) {
  buffers.nearest.clear(rect.width, rect.height);
  for (std::uint32_t i = 0; i < scene.instances().size(); ++i) {
    const glm::dmat4 clip_from_object = viewing.clip_from_object(scene.instances()[i].world_from_object);
    buffers.draw_edges(scene, i, clip_from_object, settings, rect);
  }
}

bool is_edge_seen(const DepthPlane& surface, float edge_r, int x, int y, float line_width) {
  constexpr float snapping = 2.0f / subpixels;
  constexpr float rounding = 0x1p-20f;
  const float r = surface.at(x, y);
  const float tolerance = steepness(surface) * (0.5f * line_width + snapping) + r * rounding;
  return edge_r >= r - tolerance;
}

}  // namespace velum
