#pragma once

#include <cstdint>

#include "scene.hpp"

namespace velum {

/// The most texels that load_textures() reads into one scene; in memory each takes some 22 bytes.
inline constexpr std::uint64_t max_scene_texels = std::uint64_t{1} << 27;

/// Reads the pictures that materials name (Material::base_colour_texture) and have no texture for yet: PNG,
/// JPEG, BMP, TGA, PPM. Each file is read once, however many materials name it. What is missing, broken or no
/// regular file, or would exceed max_scene_texels, is left out and told in Scene::notes.
void load_textures(Scene& scene);

}  // namespace velum
