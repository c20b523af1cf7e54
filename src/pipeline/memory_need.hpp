#pragma once

#include <cstdint>

#include "../base/rect.hpp"
#include "../scene/scene.hpp"
#include "settings.hpp"

namespace velum {

/// Whether a surface of the scene may let what lies behind it shine through; true of a custom shader.
bool may_be_translucent(const Scene& scene, const RenderSettings& settings);

/// Bytes of a Picture of the rectangle, padding included.
std::uint64_t picture_bytes(const Rect& rect);

/// Rows that are rendered at a time: all, unless the samples of so many take too much memory.
int sample_band_height(const Scene& scene, const RenderSettings& settings, const Rect& rect);

/// Bytes of the buffers that a frame works in, of a band of it under samples: the visibility buffer, a second
/// one for a wireframe, what waits for the tiles of the vector z-buffer, and, where something may be
/// translucent, what the pixels gather. Lists of fragments come on top, as many as the ceiling leaves room
/// for.
std::uint64_t buffer_bytes(const Scene& scene, const RenderSettings& settings, const Rect& rect);

/// The bytes that the settings' ceiling (0: half of the machine's memory; what writing files takes is less
/// than the other half) leaves beside `bytes`.
/// @throws Error (limit) if it leaves nothing
std::uint64_t memory_left(std::uint64_t bytes, const RenderSettings& settings);

}  // namespace velum
