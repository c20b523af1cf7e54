#pragma once

#include <cstddef>
#include <string>

namespace velum {

/// Refuses what would take more memory than a file of this size may ask for (load_scene.hpp states the
/// bound). Only crafted files come near it: one byte that repeats a corner can make a triangle of 300 bytes.
/// @param what  e.g. "the triangles with flat normals"
/// @throws Error (read)
void require_within_memory_bound(std::size_t needed_bytes, std::size_t file_bytes, const std::string& what,
                                 const std::string& where);

}  // namespace velum
