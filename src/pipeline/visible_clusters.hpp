#pragma once

#include <cstdint>
#include <vector>

#include "../image/visibility_buffer.hpp"
#include "scene_octrees.hpp"

namespace velum {

/// Marks the clusters that a picture shows.
/// @param is_visible  out: 1 or 0 per cluster of the scene
void mark_visible_clusters(const Scene& scene, const SceneOctrees& octrees, const VisibilityBuffer& buffer,
                           std::vector<std::uint8_t>& is_visible);

}  // namespace velum
