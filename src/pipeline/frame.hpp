#pragma once

#include <cstdint>
#include <vector>

#include "hierarchical_stage.hpp"
#include "ray_stage.hpp"
#include "render.hpp"
#include "sample_stage.hpp"
#include "shade_stage.hpp"
#include "stages.hpp"
#include "tile_stage.hpp"
#include "wireframe_stage.hpp"

namespace velum {

/// What a Renderer keeps between frames.
struct Renderer::Buffers {
  ClipVertices vertices;
  std::vector<ScreenTriangle> screen_triangles;
  ScanlineTables scanline;
  VisibilityBuffer visibility;
  WireframeBuffers wireframe;
  TileStageBuffers tiles;
  RayStageBuffers rays;
  HierarchicalBuffers hierarchy;
  Executor executor;
  int threads = 1;  ///< as asked for; 0: all
  ExecutorKind executor_kind = ExecutorKind::tbb;
  ShadeBuffers shaders;
  LayerBuffers layers;
  SampleBuffers samples;
  Image<Rgba8> band;  ///< of a larger picture
  Picture picture;
};

/// Tells the callback of the settings how much is done, 0…1.
/// @throws Error (cancelled) if it says so
void report_progress(const RenderSettings& settings, double share);

/// One frame, from the scene to the visibility buffer, by the method of the settings.
struct Frame {
  const Scene& scene;
  const RenderSettings& settings;
  const ViewingTransform& viewing;
  Rect rect;
  Renderer::Buffers& buffers;
  Counters& counters;
  FragmentLists* lists = nullptr;  ///< where given, all fragments go there and none to the visibility buffer
  SamplePosition sample = pixel_centre;  ///< where in the pixels visibility is decided
  const TileSink* sink = nullptr;        ///< see TileStageInput; only if is_for_tiles()
  Rect within = rect;                    ///< instances that lie beside this are left out; holds `rect`
  double progress_from = 0.0;
  double progress_to = 0.8;

  /// The vector kernels know the definition's depth only, and no lists.
  bool is_for_kernels() const;
  /// What is behind the first layer is hidden, too; and bounds hold for pixel centres.
  bool is_for_hierarchy() const;
  bool is_for_tiles() const { return is_for_kernels() && !is_for_hierarchy(); }

  /// Fills the visibility buffer or the lists; or leaves tiles with the sink.
  void draw_scene();

 private:
  template <typename SetUp>
  void draw(std::size_t count, std::uint32_t first_primitive, const SetUp& set_up_one);
  void draw_triangles(const Mesh& mesh, std::uint32_t first_primitive, bool mirrored);
  void draw_lines(const Mesh& mesh, std::uint32_t first_primitive);
  void draw_instance(std::uint32_t index);
  void draw_lines_of_all();
  Viewport viewport() const { return {settings.width, settings.height}; }
};

}  // namespace velum
