#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace velum {

enum class FileFormat { obj, ascii_stl, binary_stl, ply };

/// What the bytes are: by their content; where that could be several, by the name's extension.
/// @throws Error (read) for an empty file and for one that is none of these, with what it looks like
FileFormat format_of(std::span<const std::byte> bytes, const std::string& name);

}  // namespace velum
