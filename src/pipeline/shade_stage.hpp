#pragma once

#include <cstdint>
#include <vector>

#include "../shading/plain_rows.hpp"
#include "../visibility/fragment_lists.hpp"
#include "pixel_shader.hpp"
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

/// Neighbouring pixels of a row that show the same: begin ≤ x < end.
struct ShadeRun {
  int row;
  int begin;
  int end;
  std::uint32_t primitive;
};

/// Evaluates each visible fragment once and writes every output that is wanted. Depth, ids and normals are
/// those of the first layer; the colour gathers layer behind layer until an opaque fragment, the background
/// or the layer limit.
class ShadeStage {
 public:
  /// @param shaders  kept from frame to frame for their memory
  ShadeStage(const ShadeInput& input, const PictureTarget& target, LayerBuffers& layers,
             std::vector<PixelShader>& shaders);

  /// Runs on all threads, tile by tile; with a custom shader on the calling thread alone.
  void shade_first_layer(const VisibilityBuffer& buffer, Counters& counters);
  /// The smallest rectangle of picture pixels around all whose first layer is translucent; empty for none.
  Rect translucent_box() const { return translucent_box_; }
  /// Shades the further layers of the translucent pixels in a part of the picture, from its sorted lists.
  void shade_behind(const FragmentLists& lists, const Rect& part, Counters& counters);
  /// Puts translucent pixels over the background and writes them.
  void finish();

 private:
  /// What a worker found in its tiles.
  struct Found {
    std::uint64_t shaded = 0;
    Rect translucent_box;
  };

  template <typename Function>
  void for_each(std::size_t count, const Function& function);
  std::uint64_t shade_stored(const VisibilityBuffer& buffer, const Rect& part) const;
  void shade_tile(const VisibilityBuffer& buffer, const Rect& tile, PixelShader& shader, Found& found);
  void shade_run(const ShadeRun& run, const float* reversed_depths, PixelShader& shader, Found& found);
  void shade_point(int x, int y, float reversed_depth, PixelShader& shader, Found& found);
  void write_background(const ShadeRun& run);
  void open(int x, int y, Found& found);
  void open_part(const Rect& part);
  bool add_behind(int x, int y, const glm::vec4& colour);
  bool shade_further(int x, int y, std::uint64_t fragment);

  const ShadeContext context_;
  const ShadeInput& input_ = context_.input;
  const PictureTarget target_;
  const bool needs_surfaces_;
  const ShadePlainRows shade_plain_ = plain_rows_kernel(input_.settings.isa);
  LayerBuffers& layers_;
  std::vector<PixelShader>& shaders_;  // one per worker
  Rect translucent_box_;
};

}  // namespace velum
