#include "wireframe_stage.hpp"

#include <algorithm>

#include "../visibility/zbuffer.hpp"
#include "line_stages.hpp"

namespace velum {
namespace {

/// Triangles whose edges one worker sets up in one go.
constexpr std::size_t run_size = 4096;
/// Runs set up before their screen triangles are gathered: bounds the memory.
constexpr std::size_t runs_per_round = 16;
/// Screen triangles that wait to be drawn; drawing passes over the whole picture.
constexpr std::size_t most_waiting = std::size_t{1} << 17;
/// Rows of the picture that one worker draws in one go.
constexpr int band_height = 64;
/// Vertices transformed in one go.
constexpr std::size_t vertex_chunk = 8192;

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

/// Whether a triangle's box and the rectangle's rows have a place in common.
bool meets_rows(const ScreenTriangle& triangle, const Rect& rect) {
  const auto& v = triangle.vertices;
  return std::max({v[0].y, v[1].y, v[2].y}) >= rect.top * subpixels &&
         std::min({v[0].y, v[1].y, v[2].y}) <= rect.bottom() * subpixels;
}

template <typename T>
void copy_rows(const Image<T>& from, int from_row, Image<T>& to, int to_row, int rows) {
  for (int y = 0; y < rows; ++y) {
    std::copy_n(from.row(from_row + y), from.width(), to.row(to_row + y));
  }
}

class WireframeStage {
 public:
  WireframeStage(const WireframeInput& input, WireframeBuffers& buffers) : input_(input), buffers_(buffers) {
    buffers.nearest.clear(input.rect.width, input.rect.height);
    buffers.bands.resize(static_cast<std::size_t>(input.executor.threads()));
    for (VisibilityBuffer& band : buffers.bands) {
      band.clear(input.rect.width, std::min(band_height, input.rect.height));
    }
    buffers.runs.resize(runs_per_round);
    buffers.waiting.clear();
  }

  void draw() {
    for (const Instance& instance : input_.scene.instances()) add_instance(instance);
    draw_waiting();
  }

 private:
  void add_instance(const Instance& instance) {
    const Mesh& mesh = input_.scene.meshes()[instance.mesh];
    transform(mesh.positions.span(), input_.viewing.clip_from_object(instance.world_from_object));
    const std::size_t runs = (mesh.triangles.size() + run_size - 1) / run_size;
    for (std::size_t first = 0; first < runs; first += runs_per_round) {
      const std::size_t count = std::min(runs_per_round, runs - first);
      input_.executor.for_each(count, [&](std::size_t i, int) {
        set_up_run(mesh, (first + i) * run_size, is_mirroring(instance.world_from_object), buffers_.runs[i]);
      });
      for (std::size_t i = 0; i < count; ++i) gather(buffers_.runs[i].screen_triangles);
    }
  }

  void transform(std::span<const glm::vec3> positions, const glm::dmat4& clip_from_object) {
    ClipVertices& out = buffers_.vertices;
    out.positions.resize(positions.size());
    out.outcodes.resize(positions.size());
    input_.executor.for_each(
        (positions.size() + vertex_chunk - 1) / vertex_chunk, [&](std::size_t chunk, int) {
          const std::size_t first = chunk * vertex_chunk;
          for (std::size_t i = first; i < std::min(first + vertex_chunk, positions.size()); ++i) {
            out.positions[i] = clip_position(clip_from_object, positions[i]);
            out.outcodes[i] = outcode(out.positions[i]);
          }
        });
  }

  /// An edge between two runs is drawn twice, which changes nothing.
  void set_up_run(const Mesh& mesh, std::size_t first, bool mirrored, WireframeBuffers::Run& run) const {
    const RenderSettings& settings = input_.settings;
    Counters uncounted;
    run.edges.clear();
    for (std::size_t i = first; i < std::min(first + run_size, mesh.triangles.size()); ++i) {
      const glm::uvec3& triangle = mesh.triangles[i];
      const TriangleFate fate =
          assemble(buffers_.vertices, triangle, mirrored, settings.cull, {}, uncounted).fate;
      if (fate == TriangleFate::accepted || fate == TriangleFate::to_clip) append_edges(triangle, run.edges);
    }
    std::sort(run.edges.begin(), run.edges.end(), is_before);
    run.edges.erase(std::unique(run.edges.begin(), run.edges.end()), run.edges.end());

    const Viewport viewport{settings.width, settings.height};
    run.screen_triangles.clear();
    for (const glm::uvec2& edge : run.edges) {
      set_up_segment(buffers_.vertices, edge, 0, settings.line_width, viewport, uncounted,
                     run.screen_triangles);
    }
    move_all_to(input_.sample, run.screen_triangles);
  }

  void gather(const std::vector<ScreenTriangle>& triangles) {
    buffers_.waiting.insert(buffers_.waiting.end(), triangles.begin(), triangles.end());
    if (buffers_.waiting.size() >= most_waiting) draw_waiting();
  }

  void draw_waiting() {
    if (buffers_.waiting.empty()) return;
    const int bands = (input_.rect.height + band_height - 1) / band_height;
    input_.executor.for_each(static_cast<std::size_t>(bands), [&](std::size_t i, int worker) {
      draw_band(static_cast<int>(i) * band_height, buffers_.bands[static_cast<std::size_t>(worker)]);
    });
    buffers_.waiting.clear();
  }

  void draw_band(int top, VisibilityBuffer& band) const {
    const Rect& rect = input_.rect;
    const int rows = std::min(band_height, rect.height - top);
    copy_rows(buffers_.nearest.reversed_depth, top, band.reversed_depth, 0, rows);
    copy_rows(buffers_.nearest.primitive, top, band.primitive, 0, rows);
    const RasterTarget target{band, {rect.left, rect.top + top, rect.width, rows}};
    for (const ScreenTriangle& triangle : buffers_.waiting) {
      if (meets_rows(triangle, target.rect)) rasterize_zbuffer({&triangle, 1}, target);
    }
    copy_rows(band.reversed_depth, 0, buffers_.nearest.reversed_depth, top, rows);
    copy_rows(band.primitive, 0, buffers_.nearest.primitive, top, rows);
  }

  const WireframeInput& input_;
  WireframeBuffers& buffers_;
};

}  // namespace

void draw_wireframe(const WireframeInput& input, WireframeBuffers& buffers) {
  WireframeStage(input, buffers).draw();
}

bool is_edge_seen(const DepthPlane& surface, float edge_r, int x, int y, float line_width) {
  constexpr float snapping = 2.0f / subpixels;
  constexpr float rounding = 0x1p-20f;
  const float r = surface.at(x, y);
  const float tolerance = steepness(surface) * (0.5f * line_width + snapping) + r * rounding;
  return edge_r >= r - tolerance;
}

}  // namespace velum
