#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "load_scene.hpp"

namespace velum {

/// Whether the bytes are a binary STL file, to the byte: 80 + 4 + 50 · n. ("solid" may begin one of those
/// too.)
bool is_exact_binary_stl(std::span<const std::byte> bytes);

/// STL (3D Systems, "Stereolithography Interface Specification", 1988): facets without shared vertices. Equal
/// positions become one vertex (-0 is 0; otherwise bit for bit). The normals and attribute bytes in the file
/// are not used: the first are often wrong, the second have no agreed meaning; front is where the corners
/// turn counter-clockwise.
/// @throws Error (read) with file:line or byte
Scene read_ascii_stl(std::string_view text, const std::string& name, const LoadOptions& options);
Scene read_binary_stl(std::span<const std::byte> bytes, const std::string& name, const LoadOptions& options);

}  // namespace velum
