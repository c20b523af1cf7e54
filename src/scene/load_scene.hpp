#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "scene.hpp"

namespace velum {

/// What a file without normals gets.
enum class MissingNormals { smooth, flat };

struct LoadOptions {
  MissingNormals missing_normals = MissingNormals::smooth;
};

/// Reads OBJ (+ MTL), STL (ASCII, binary) or PLY (ASCII, both byte orders): decided by content first, by
/// extension second. "builtin:NAME" gives a built-in shape, "builtin:checkerboard" a textured plane. Numbers
/// are read correctly rounded, whatever the locale; polygons, concave ones too, are triangulated. An OBJ's
/// textures are loaded, see load_textures(); those that cannot be are a note.
/// @throws Error (read) with file:line (or byte offset) and what to do; for no bytes does it crash, hang or
/// allocate more than 64 times the file's size + 1 MiB, textures apart
Scene load_scene(const std::string& path, const LoadOptions& options = {});

/// The same from memory. @param name  shown in errors, and its extension is the second hint
/// @param directory  where referenced files (MTL, pictures) are looked for; empty: they are not read
Scene load_scene_from_memory(std::span<const std::byte> bytes, const std::string& name,
                             const std::filesystem::path& directory = {}, const LoadOptions& options = {});

}  // namespace velum
