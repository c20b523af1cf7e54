#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "../shading/line_view.hpp"
#include "../shading/shade.hpp"
#include "../shading/triangle_planes.hpp"
#include "../shading/triangle_view.hpp"
#include "../visibility/depth_plane.hpp"
#include "../visibility/sample_positions.hpp"
#include "stages.hpp"

namespace velum {

/// What the shading stage needs to know.
struct ShadeInput {
  const Scene& scene;
  const Camera& camera;
  const ViewingTransform& viewing;
  const RenderSettings& settings;
  Rect rect;  ///< the part of the picture that the buffer holds
  Executor& executor;
  bool needs_points = false;  ///< metric depth or normals are wanted, which differ from pixel to pixel
  const VisibilityBuffer* wireframe = nullptr;  ///< the nearest edges, drawn over the first layer
};

/// What depends on the scene and its lights; kept from frame to frame for its memory.
struct ShadeMemory {
  Lighting lighting;
  std::vector<RowLight> row_lights;          ///< the same lights for the vector kernels
  std::vector<glm::dmat4> clip_from_object;  ///< of each instance
};

/// What the shading of every pixel of a frame has in common.
struct ShadeContext {
  /// @param kept  whose memory is used, and given back in the end
  explicit ShadeContext(const ShadeInput& shade_input, ShadeMemory* kept = nullptr);
  ~ShadeContext();
  ShadeContext(const ShadeContext&) = delete;
  ShadeContext& operator=(const ShadeContext&) = delete;

  /// Whether a triangle without a texture has one colour all over.
  bool has_plain_triangles() const;

  const ShadeInput input;
  Viewer viewer;
  MetricRange range;
  ShadeMemory own;
  const Lighting& lighting = own.lighting;
  const std::vector<glm::dmat4>& clip_from_object = own.clip_from_object;

 private:
  ShadeMemory* const kept_;
};

/// A visible primitive set up for shading.
struct VisiblePrimitive {
  std::uint32_t primitive = no_primitive;
  PrimitiveKind kind = PrimitiveKind::triangle;
  std::uint32_t object = 0;           ///< its instance
  std::optional<Rgba8> plain_colour;  ///< where it is opaque and the same at every pixel
  TriangleView triangle;              ///< if it is one, and more than a plain colour is wanted of it
  LitTriangle lit;
  TrianglePlanes planes;  ///< of a triangle that was asked for them
  bool has_planes = false;
  DepthPlane depth;  ///< of a triangle under a wireframe
  LineView line;     ///< if it is a segment or a point
};

/// Evaluates pixels of visible primitives; each worker has its own. The primitives met lately are kept set
/// up: a small triangle is seen on several rows.
class PixelShader {
 public:
  /// Forgets everything. @param context  must outlive every further call
  void begin(const ShadeContext& context);

  /// Turns to a primitive; the calls below are about its pixels. @pre primitive < primitive_count()
  void select(std::uint32_t primitive);
  const VisiblePrimitive& selected() const { return *selected_; }

  /// The selected triangle as the vector kernels read it, with the colours of the shading.
  const TrianglePlanes& planes();

  /// @param x, y  pixel of the buffer
  SurfacePoint surface(int x, int y, float reversed_depth) const;
  /// The same elsewhere in the pixel. @param from_centre  in pixels, y down
  SurfacePoint surface(int x, int y, const glm::dvec2& from_centre, float reversed_depth) const;
  /// Linear, straight alpha.
  glm::vec4 colour_of(const SurfacePoint& point) const;
  void colours_of(const SurfacePoint* points, std::size_t count, glm::vec4* colours) const;
  /// Whether an edge of the wireframe is seen at a pixel of the buffer.
  bool is_wire(int x, int y, float reversed_depth) const;
  /// The same at a sample, of which ShadeInput::wireframe has the edges.
  bool is_wire(int x, int y, const SamplePosition& sample, float reversed_depth) const;

 private:
  void set_up(std::uint32_t primitive, VisiblePrimitive& visible) const;
  void set_up_triangle(const PrimitivePlace& place, VisiblePrimitive& visible) const;
  void set_up_line(const PrimitivePlace& place, VisiblePrimitive& visible) const;

  const ShadeContext* context_ = nullptr;
  std::vector<VisiblePrimitive> lately_;  // each primitive has one place where it can be
  VisiblePrimitive* selected_ = nullptr;
};

}  // namespace velum
