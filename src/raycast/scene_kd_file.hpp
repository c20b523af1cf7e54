#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene_caster.hpp"

namespace velum {

/// Writes the kd-trees of all meshes of a scene to one file, to be read again instead of being built. The
/// file has no triangles, only fingerprints of them. "-" is standard output. @throws Error (write)
///
/// The file is little-endian: "velum-ks"; as 32-bit words the version (1) and the number of meshes; of each
/// mesh the size of its tree's bytes (64 bits); then these, as save_kd_tree() writes them, checksums and all.
/// @pre caster.kind() is kd_tree
void save_kd_trees(const std::filesystem::path& path, const SceneCaster& caster);

/// Reads the kd-trees of a scene's meshes; to be handed to RenderSettings::caster. "-" is standard input.
/// A file that is not whole and sound is refused, and so is one over other meshes; see load_kd_tree().
/// @throws Error (read), with the file and what to do
std::unique_ptr<SceneCaster> load_kd_trees(const std::filesystem::path& path, const Scene& scene);

/// The same in memory. @param where  names the bytes in messages
std::vector<std::byte> kd_trees_bytes(const SceneCaster& caster);
std::unique_ptr<SceneCaster> kd_trees_from_bytes(std::span<const std::byte> bytes, const Scene& scene,
                                                 const std::string& where);

}  // namespace velum
