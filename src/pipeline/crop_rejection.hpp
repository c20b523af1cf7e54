#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>

#include "../base/rect.hpp"
#include "../scene/scene.hpp"
#include "settings.hpp"

namespace velum {

/// Whether nothing of an instance can cover a pixel of a part of the picture, judged by its box: then its
/// vertices need no transform. Never true of the whole picture, where the stages count what they reject.
/// @param rect  the part that is rendered
bool is_beside(const Scene& scene, std::uint32_t instance, const glm::dmat4& clip_from_object,
               const RenderSettings& settings, const Rect& rect);

}  // namespace velum
