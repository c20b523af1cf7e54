#pragma once

#include "../base/rect.hpp"
#include "../projection/camera.hpp"
#include "../projection/viewing_transform.hpp"
#include "picture.hpp"
#include "settings.hpp"

namespace velum {

/// The largest width and height of a picture.
inline constexpr int largest_side = 32768;

/// The part of the picture that is rendered: the crop, or all of it.
/// @throws Error (usage) for sizes out of range or a crop that is empty or leaves the picture
Rect requested_rect(const RenderSettings& settings);

/// @throws Error (usage) if the pixel (of the whole picture, y down) is not in the rectangle
void check_pixel(const Rect& rect, int x, int y);

/// @throws Error (usage) for a depth interpolation or format that the visibility method does not have
void check_method(const RenderSettings& settings);

/// @throws Error (usage) for a line width or point size out of range
void check_widths(const RenderSettings& settings);

/// @throws Error (usage) for a number of samples that no pattern has
void check_samples(const RenderSettings& settings);

/// @throws Error (usage) for a number of threads out of range, or an instruction set that this machine or
/// this build has not
void check_machine(const RenderSettings& settings);

/// The composite for this picture. @throws Error (usage) if the camera insists on another aspect (half a
/// pixel is let pass)
ViewingTransform requested_view(const Camera& camera, const RenderSettings& settings);

/// @throws Error (usage) if a view that is wanted does not have the rectangle's size
void check_target(const PictureTarget& target, const Rect& rect);

}  // namespace velum
