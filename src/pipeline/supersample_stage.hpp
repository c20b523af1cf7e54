#pragma once

#include <functional>

#include "../image/downsample.hpp"
#include "../scene/scene.hpp"
#include "settings.hpp"

namespace velum {

/// The most times that a picture can be rendered larger.
inline constexpr int most_supersampling = 8;

/// @throws Error (usage) for a factor out of range, or one that makes the picture, its lines or its points
/// larger than can be drawn
void check_supersampling(const RenderSettings& settings);

/// The settings of the larger picture: `supersample` times the size, widths of lines and points included.
/// Its crop is the whole.
RenderSettings enlarged(const RenderSettings& settings);

/// Rows of the larger picture that are rendered at a time: so many that all there is of them fits into a
/// fixed amount of memory.
int supersample_band_height(int width);

/// Renders these pixels of the larger picture, colour only.
using RenderColour = std::function<void(const Rect& part, const ImageView<Rgba8>& colour,
                                        double progress_from, double progress_to)>;

/// Makes a picture from one `supersample` times its size, band by band: a crop has exactly the pixels of the
/// whole.
/// @param rect    the part of the picture wanted
/// @param target  of its size
/// @param band    kept for its memory
void supersample(const RenderSettings& settings, const Rect& rect, const ImageView<Rgba8>& target,
                 Image<Rgba8>& band, const RenderColour& render);

}  // namespace velum
