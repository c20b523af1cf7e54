#pragma once

#include <array>
#include <span>

#include "../shading/surface_rows.hpp"
#include "../shading/texture_rows.hpp"
#include "pixel_shader.hpp"

namespace velum {

/// What the vector kernels are to find out, the same for every pixel of a frame.
struct RowContext {
  RowContext(const ShadeContext& shade_context, const PictureTarget& target);

  const ShadeContext& context;
  bool is_used;     ///< a vector instruction set, and no custom shader or wireframe
  bool has_colour;  ///< surfaces give the colour; otherwise it is not wanted or follows from the id
  bool has_linear;  ///< … as linear colours, which may be translucent; otherwise as codes
  SurfaceNeeds needs;
  InterpolateSurface interpolate = nullptr;
  TextureRow lay_texture = nullptr;
  LightRow light = nullptr;
};

/// Shades neighbouring pixels of triangles together, at most most_row_pixels of a row at a time; each worker
/// has its own.
class RowShader {
 public:
  /// @param context  must outlive every further call
  void begin(const RowContext& context) {
    context_ = &context;
    texture_of_ = nullptr;
  }

  /// Whether the pixels of a primitive may be added: it is no line, and has area.
  bool can_shade(const VisiblePrimitive& primitive) const;

  /// Begins with the pixel (x, y) of the whole picture, whose index is 0.
  void start(int x, int y);
  /// Pixels of the primitive that is selected. @pre can_shade() it; not before the pixels already added
  void add(PixelShader& shader, std::size_t begin, std::size_t end);
  /// Lights what was added.
  void finish();

  /// Neighbouring pixels that were added, all of one material where that matters.
  struct Stretch {
    const Material* material;
    std::size_t begin, end;
  };
  std::span<const Stretch> stretches() const { return {stretches_.data(), stretch_count_}; }
  const SurfaceRow& row() const { return row_; }
  /// What a debug view shows of a pixel. @pre !RowContext::has_linear
  Rgba8 codes_at(std::size_t i) const;

 private:
  void lay_texture(const Material& material, const TrianglePlanes& planes, std::size_t begin,
                   std::size_t end);
  void light(const Stretch& stretch);

  const RowContext* context_ = nullptr;
  int x_ = 0;
  int y_ = 0;
  std::size_t stretch_count_ = 0;
  std::array<Stretch, most_row_pixels> stretches_{};
  SurfaceRow row_{};
  const Material* texture_of_ = nullptr;  ///< whose texture is at hand
  RowTexture texture_{};
};

}  // namespace velum
