#pragma once

#include <cstdint>
#include <vector>

#include "../shading/line_view.hpp"
#include "../shading/shade.hpp"
#include "../shading/triangle_view.hpp"
#include "../visibility/fragment_lists.hpp"
#include "stages.hpp"

namespace velum {

/// What translucent pixels have gathered so far; untouched while everything seen is opaque.
struct LayerBuffers {
  /// A pixel whose colour still lets a further layer through.
  struct OpenPixel {
    std::uint16_t column, row;
  };

  Image<glm::vec4> colour;             ///< linear, premultiplied, front to back
  Image<std::uint8_t> is_translucent;  ///< 1 where the first layer is not opaque
  std::vector<OpenPixel> open;         ///< of the part being shaded
  FragmentLists behind;                ///< what lies behind the first layer

  void clear(int width, int height) {
    colour.resize(width, height, glm::vec4(0.0f));
    is_translucent.resize(width, height, 0);
  }
};

/// What the shading stage needs to know.
struct ShadeInput {
  const Scene& scene;
  const Camera& camera;
  const ViewingTransform& viewing;
  const RenderSettings& settings;
  Rect rect;                                    ///< the part of the picture that the buffer holds
  const VisibilityBuffer* wireframe = nullptr;  ///< the nearest edges, drawn over the first layer
};

/// Evaluates each visible fragment once and writes every output that is wanted. Depth, ids and normals are
/// those of the first layer; the colour gathers layer behind layer until an opaque fragment, the background
/// or the layer limit.
class ShadeStage {
 public:
  ShadeStage(const ShadeInput& input, const PictureTarget& target, LayerBuffers& layers);

  void shade_first_layer(const VisibilityBuffer& buffer, Counters& counters);
  /// The smallest rectangle of picture pixels around all whose first layer is translucent; empty for none.
  Rect translucent_box() const { return translucent_box_; }
  /// Shades the further layers of the translucent pixels in a part of the picture, from its sorted lists.
  void shade_behind(const FragmentLists& lists, const Rect& part, Counters& counters);
  /// Puts translucent pixels over the background and writes them.
  void finish();

 private:
  /// A visible primitive as the shading needs it; kept while neighbouring pixels show the same one.
  struct VisiblePrimitive {
    std::uint32_t primitive = no_primitive;
    PrimitiveKind kind = PrimitiveKind::triangle;
    TriangleView triangle;  ///< if it is one
    LitTriangle lit;
    DepthPlane depth;  ///< of a triangle under a wireframe
    LineView line;     ///< if it is a segment or a point
  };

  void shade_first(int x, int y, std::uint32_t primitive, float reversed_depth);
  void write_background(int x, int y);
  void open(int x, int y);
  void open_part(const Rect& part);
  bool add_behind(int x, int y, const glm::vec4& colour);
  bool shade_further(int x, int y, std::uint64_t fragment);
  void set_primitive(std::uint32_t primitive);
  void set_triangle(const PrimitivePlace& place);
  void set_line(const PrimitivePlace& place);
  SurfacePoint surface(int x, int y, float reversed_depth) const;
  glm::vec4 colour_of(const SurfacePoint& point) const;
  bool is_wire(int x, int y, float reversed_depth) const;

  const ShadeInput input_;
  const PictureTarget target_;
  LayerBuffers& layers_;
  Viewer viewer_;
  MetricRange range_;
  Lighting lighting_;
  std::vector<glm::dmat4> clip_from_object_;
  VisiblePrimitive visible_;
  Rect translucent_box_;
};

}  // namespace velum
