#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "../shading/plain_rows.hpp"
#include "../shading/wireframe.hpp"
#include "../visibility/fragment_lists.hpp"
#include "layer_blend.hpp"
#include "pixel_shader.hpp"
#include "plain_tile.hpp"
#include "row_shader.hpp"
#include "stages.hpp"

namespace velum {

/// What each worker has for itself.
struct ShadeWorker {
  PixelShader pixel;
  RowShader row;
  std::vector<SurfacePoint> points;  ///< of a run
  std::array<glm::vec4, most_row_pixels> colours{};
  std::vector<LayerBuffers::OpenPixel> open;  ///< of the band being shaded
  std::uint64_t shaded = 0;
  std::uint64_t layers = 0;
  Rect translucent_box;
};

/// What the stage keeps from frame to frame, for its memory.
struct ShadeBuffers {
  std::vector<ShadeWorker> workers;
  ShadeMemory memory;
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
  ShadeStage(const ShadeInput& input, const PictureTarget& target, LayerBuffers& layers,
             ShadeBuffers& buffers);

  /// Runs on all threads, part by part; with a custom shader on the calling thread alone.
  void shade_first_layer(const VisibilityBuffer& buffer, Counters& counters);

  /// Whether depths and ids are all that is wanted, so that pixels may come tile by tile while they are
  /// drawn.
  bool takes_tiles() const;
  /// Writes a tile of the first layer; on several threads at once. @pre takes_tiles()
  /// @param pixels  nullptr if nothing is seen there
  /// @param tile    in the picture
  void take_tile(const TileBuffer* pixels, const Rect& tile, int worker);
  /// To be called after the last tile.
  void end_first_layer(Counters& counters);

  /// The smallest rectangle of picture pixels around all whose first layer is translucent; empty for none.
  Rect translucent_box() const { return translucent_box_; }
  /// Shades the further layers of the translucent pixels in a part of the picture, from its sorted lists.
  void shade_behind(const FragmentLists& lists, const Rect& part, Counters& counters);
  /// Puts translucent pixels over the background and writes them.
  void finish();

 private:
  template <typename Function>
  void for_each(std::size_t count, const Function& function);
  template <typename Function>
  void for_each_band(int top, int bottom, const Function& function);
  PlainOutput plain_output(int left, int top) const;
  std::uint64_t shade_stored(const VisibilityBuffer& buffer, const Rect& part) const;
  void shade_tile(const VisibilityBuffer& buffer, const Rect& tile, ShadeWorker& worker);
  void shade_run(const ShadeRun& run, int left, const float* reversed_depths, ShadeWorker& worker);
  void write_stretch(int y, int left, const RowShader::Stretch& stretch, ShadeWorker& worker);
  void shade_points(const ShadeRun& run, const float* reversed_depths, ShadeWorker& worker);
  void write_colour(int x, int y, const glm::vec4& colour, ShadeWorker& worker);
  void write_background(const ShadeRun& run);
  void open_band(const Rect& band, ShadeWorker& worker) const;
  bool shade_further(int x, int y, std::uint64_t fragment, PixelShader& shader);

  const ShadeContext context_;
  const ShadeInput& input_ = context_.input;
  const PictureTarget target_;
  const RowContext rows_;
  const bool needs_surfaces_;
  const ShadePlainRows shade_plain_rows_ = plain_rows_kernel(input_.settings.isa);
  const ShadePlainTile shade_plain_tile_ = plain_tile_kernel(input_.settings.isa);
  const glm::vec4 ink_ =
      input_.wireframe == nullptr ? glm::vec4(0.0f) : wireframe_ink(input_.scene, input_.settings.background);
  LayerBuffers& layers_;
  std::vector<ShadeWorker>& workers_;
  Rect translucent_box_;
};

}  // namespace velum
