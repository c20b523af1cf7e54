#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "colour.hpp"
#include "image.hpp"

namespace velum {

/// A picture of any format there is a reader for, decided by its content: PNG, PPM (P6), JPEG, BMP; and TGA,
/// which has no mark of its own, where the name ends in .tga.
///
/// At most `most_pixels`, and of JPEG, BMP and TGA at most 1024 for each byte of the file (the formats hold
/// fewer), are decoded; more is refused before memory is taken for them.
/// @param name  how messages call the file, and its extension decides about TGA
/// @throws Error (read)
Image<Rgba8> decode_picture(std::span<const std::byte> bytes, const std::string& name,
                            std::uint64_t most_pixels);

}  // namespace velum
