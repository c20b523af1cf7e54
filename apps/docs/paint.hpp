#pragma once

#include <span>
#include <string>
#include <velum/velum.hpp>

namespace velum_docs {

inline constexpr velum::Rgba8 paper{255, 255, 255, 255};
inline constexpr velum::Rgba8 ink{20, 20, 20, 255};
inline constexpr velum::Rgba8 faint{150, 150, 150, 255};
inline constexpr velum::Rgba8 grid_colour{205, 205, 205, 255};
inline constexpr velum::Rgba8 red{200, 0, 0, 255};
inline constexpr velum::Rgba8 blue{40, 80, 200, 255};
inline constexpr velum::Rgba8 green{20, 130, 60, 255};

/// The colour with another opacity.
velum::Rgba8 with_alpha(velum::Rgba8 colour, std::uint8_t alpha);

/// Paints a picture with its top left corner at (left, top), each pixel as a square of `scale` pixels.
void paint_image(velum::Canvas& canvas, const velum::Image<velum::Rgba8>& image, int left, int top,
                 int scale = 1);

/// Pictures of one height side by side, `gap` white pixels between them.
velum::Image<velum::Rgba8> side_by_side(std::span<const velum::Image<velum::Rgba8>> pictures, int gap);

}  // namespace velum_docs
