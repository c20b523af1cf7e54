#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "../shading/wireframe.hpp"
#include "../visibility/sample_positions.hpp"
#include "sample_resolve.hpp"
#include "shade_stage.hpp"
#include "wireframe_stage.hpp"

namespace velum {

/// Rows of one run: what a worker takes at a time.
inline constexpr int run_height = 16;

/// The samples at which a pixel shows one primitive, and its colour there, evaluated once for all of them.
struct SampleGroup {
  std::uint32_t primitive;
  std::uint32_t samples;   ///< bit k: sample k
  bool is_shaded = false;  ///< whether the colour is there
  glm::vec4 colour{0.0f};  ///< linear, straight alpha
};

/// A pixel whose samples do not all see what its centre sees.
struct MixedPixel {
  std::uint16_t column, row;
  std::uint32_t primitive;  ///< at the centre
  float reversed_depth;
};

/// A pixel that lets something through, mixed or not.
struct OpenPixel {
  std::uint16_t column, row;
  std::uint32_t first_group;  ///< of its first layer
  std::uint32_t group_count;  ///< 0 if it is not mixed: its first layer is ShadeStage's
};

/// The pixels in a run of rows that the stage has, and what their shading leaves to be done. One worker at a
/// time has it.
struct MixedRows {
  std::vector<MixedPixel> pixels;
  std::vector<OpenPixel> open;
  std::vector<SampleGroup> groups;      ///< of the open pixels' first layers
  std::vector<SampleGroup> all_groups;  ///< of the open pixel at hand, layers behind the first included
  std::uint64_t shaded = 0;
  std::uint64_t layers = 1;

  void clear();
  std::span<const SampleGroup> groups_of(const OpenPixel& pixel) const {
    return std::span(groups).subspan(pixel.first_group, pixel.group_count);
  }
};

/// What the stage keeps between frames.
struct SampleBuffers {
  std::vector<VisibilityBuffer> seen;  ///< one per sample
  WireframeBuffers wireframe;
  Image<std::uint32_t> wires;  ///< bit k: an edge of the wireframe shows at sample k; bit 31: one is near
  Image<std::uint32_t> open;   ///< bit k: something may show behind what sample k sees first
  std::vector<MixedRows> rows;
  std::vector<FragmentLists> behind;  ///< one per sample
  std::vector<PixelShader> shaders;   ///< one per worker
};

/// Finds what a sample of every pixel sees, in a part of the picture: into the buffer, which it clears, or
/// into the lists where given.
using DrawSample =
    std::function<void(int sample, const Rect& rect, VisibilityBuffer& buffer, FragmentLists* lists)>;

/// Anti-aliasing by samples: each has a (depth, id) of its own, found as those of the centres are; a
/// primitive is shaded once per pixel, where centroid_of() says, and the pixel shows the mean of its samples
/// (multisampling: Akeley 1993, "RealityEngine graphics", which too keeps depth and colour per sample).
///
/// Pixels all of whose samples see what the centre sees are left to ShadeStage; this stage has the others,
/// the *mixed* ones. Behind what is translucent, in either kind, each sample goes its own way through its own
/// fragments; a primitive that some samples see first and others through something has one colour, that of
/// the former.
class SampleStage {
 public:
  /// @param input   its wireframe is that of the centres
  /// @param target  with colour
  SampleStage(const ShadeInput& input, const PictureTarget& target, SampleBuffers& buffers, DrawSample draw);

  /// Draws all samples and takes the mixed pixels out of the buffer of the centres: it shows the background
  /// there.
  void find_mixed_pixels(VisibilityBuffer& centres);

  /// Writes every output of the mixed pixels; the other outputs than colour are those of the centres. Then
  /// the colour of all pixels that let something through.
  /// @param layers          what ShadeStage left of the pixels that are not mixed
  /// @param most_fragments  kept at a time, of what lies behind first layers
  void shade(const LayerBuffers& layers, std::uint64_t most_fragments, Counters& counters);

 private:
  template <typename Function>
  void for_each_run(bool calls_shader, const Function& function) const;
  void mark_wires(int sample, int row, PixelShader& shader) const;
  void find_in_row(int row, VisibilityBuffer& centres, MixedRows& found) const;

  void write_centre(const MixedPixel& pixel, PixelShader& shader) const;
  void shade_first_layer(const MixedPixel& pixel, MixedRows& rows, PixelShader& shader) const;
  void add_groups(const MixedPixel& pixel, std::vector<SampleGroup>& groups) const;
  void shade_group(int column, int row, SampleGroup& group, float reversed_depth, PixelShader& shader) const;
  std::uint32_t wires_at(int column, int row) const;
  std::uint32_t open_samples(int column, int row, const SampleGroup& group) const;
  void put_first_layer(int column, int row, std::span<const SampleGroup> groups, glm::vec4* samples) const;
  void write_colour(int column, int row, glm::vec4* samples) const;

  // sample_behind.cpp has these.
  void shade_open_pixels(const LayerBuffers& layers, std::uint64_t most_fragments);
  void add_open_pixels(const LayerBuffers& layers);
  Rect begin_behind();
  std::vector<Rect> parts(const Rect& box, std::uint64_t most_fragments) const;
  void gather_behind(const Rect& part);
  std::span<const std::uint64_t> behind(int sample, const OpenPixel& pixel) const;
  void collect_groups(const OpenPixel& pixel, MixedRows& rows) const;
  void shade_behind(const OpenPixel& pixel, const LayerBuffers& whole, MixedRows& rows,
                    PixelShader& shader) const;
  Rect in_picture(const Rect& part) const;

  const VisibilityBuffer* const centre_wires_;
  const ShadeContext context_;
  const ShadeInput& input_ = context_.input;
  const PictureTarget target_;
  SampleBuffers& buffers_;
  const DrawSample draw_;
  const int count_ = input_.settings.samples;
  const bool may_be_open_;
  const glm::vec4 background_ = linear_from_srgb(input_.settings.background);
  const glm::vec4 ink_ =
      input_.settings.wireframe ? wireframe_ink(input_.scene, input_.settings.background) : glm::vec4(0.0f);
};

/// On all threads, but a custom shader is called on the calling thread only.
/// @param function  (rows of the buffer, what is kept for them, the worker's shader)
template <typename Function>
void SampleStage::for_each_run(bool calls_shader, const Function& function) const {
  const auto one = [&](std::size_t i, std::size_t worker) {
    const int top = static_cast<int>(i) * run_height;
    const Rect run{0, top, input_.rect.width, std::min(run_height, input_.rect.height - top)};
    function(run, buffers_.rows[i], buffers_.shaders[worker]);
  };
  if (calls_shader && input_.settings.shader) {
    for (std::size_t i = 0; i < buffers_.rows.size(); ++i) one(i, 0);
  } else {
    input_.executor.for_each(buffers_.rows.size(),
                             [&](std::size_t i, int worker) { one(i, static_cast<std::size_t>(worker)); });
  }
}

}  // namespace velum
