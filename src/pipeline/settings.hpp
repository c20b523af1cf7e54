#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "../base/executor.hpp"
#include "../base/isa.hpp"
#include "../base/rect.hpp"
#include "../clipping/clip_volume.hpp"
#include "../image/colour.hpp"
#include "../image/downsample.hpp"
#include "../raycast/accelerator_kind.hpp"
#include "../shading/shader_ref.hpp"
#include "../shading/shading.hpp"
#include "../shading/surface_point.hpp"
#include "../shading/texture_filter.hpp"
#include "../visibility/depth_format.hpp"
#include "../visibility/z_interpolation.hpp"
#include "hierarchy_settings.hpp"

namespace velum {

class SceneCaster;

/// How the question "which surface is seen?" is answered. The raster methods' answers are the same to the
/// bit; raycast asks the geometry itself and may differ at pixels that agree() explains.
enum class VisibilityMethod {
  zbuffer,
  scanline,
  raycast,
  hierarchical,  ///< z-buffer with z-pyramid and octrees: leaves out what cannot be seen
};

/// Which triangles are removed by the way they face.
enum class Cull { none, back, front };

/// Called now and then with the share done, 0…1; return false to cancel (render() then throws Error,
/// cancelled).
using Progress = std::function<bool(double)>;

/// The most threads that can be asked for.
inline constexpr int most_threads = 1024;

struct RenderSettings {
  int width = 800;  ///< pixels, 1 … 32768
  int height = 600;
  Rgba8 background{0, 0, 0, 0};  ///< sRGB; default transparent
  VisibilityMethod visibility = VisibilityMethod::zbuffer;
  AcceleratorKind accelerator = AcceleratorKind::bvh;  ///< of raycast; the bytes are the same
  /// Of raycast: what is built already for the scene as it is, or read by load_kd_trees(). Replaces
  /// `accelerator`; any number of renderers may share it.
  std::shared_ptr<const SceneCaster> caster{};
  HierarchySettings hierarchy{};  ///< of VisibilityMethod::hierarchical
  /// For teaching; other than plane only with VisibilityMethod::scanline, and then the bits differ.
  ZInterpolation z_interpolation = ZInterpolation::plane;
  DepthFormat depth_format = DepthFormat::reversed;  ///< for teaching: other formats see less
  Shading shading = Shading::phong;
  Shader shader{};  ///< custom shading; replaces `shading` where set; called on the calling thread only
  ShaderRef
      inlined_shader{};  ///< replaces both where set; called on several threads at once. See render_with()
  TextureFilter texture_filter = TextureFilter::trilinear;
  Cull cull = Cull::none;
  /// Which planes cut triangles (segments and points: always the view volume's six). Pictures differ only in
  /// which triangles cover a pixel centre within √2/512 pixel of an edge.
  ClipPolicy clip = ClipPolicy::guard;
  float line_width = 1.0f;  ///< of segments and of the wireframe, pixels, 1 … 256
  float point_size = 3.0f;  ///< side of the square that a point is drawn as, pixels, 1 … 256
  bool wireframe = false;   ///< edges of the triangles over the picture, hidden ones removed
  int samples = 1;          ///< per pixel, for smooth edges: 1, 4, 8 or 16; only colour depends on them
  /// Colour is that of a picture so many times the size, 1 … 8, made smaller by the filter; lines and points
  /// are drawn larger in it, samples apply to it, and a custom shader sees its pixels.
  int supersample = 1;
  DownsampleFilter supersample_filter = DownsampleFilter::box;
  std::uint64_t layers = 0;    ///< most translucent layers blended per pixel; 0: until exhausted
  std::optional<Rect> crop{};  ///< render only these pixels of the picture; equals the same part of the whole
  int threads = 0;  ///< how many run at once, up to most_threads; 0: as the machine has. Same bytes
  ExecutorKind executor = ExecutorKind::tbb;  ///< who runs them
  Isa isa = Isa::best;                        ///< instructions of the vector kernels; the bytes are the same
  std::uint64_t memory_ceiling = 0;  ///< bytes for outputs and buffers; 0: half of the machine's memory
  Progress progress{};

  bool has_custom_shader() const { return inlined_shader || shader; }
};

}  // namespace velum
