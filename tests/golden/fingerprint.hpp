#pragma once

#include <string>
#include <velum/velum.hpp>

namespace golden {

/// The SHA-256 of a picture's buffers as one line's text, "colour=… depth=… objects=… triangles=…": elements
/// little-endian, rows without padding, top row first.
std::string fingerprint(const velum::Picture& picture);

}  // namespace golden
