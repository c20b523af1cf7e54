#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "colour.hpp"
#include "image.hpp"

namespace velum {

/// The most bytes of pixels that a PNG is written with: 3 each where all are opaque, else 4.
inline constexpr std::uint64_t largest_png_bytes = std::uint64_t{1} << 30;

/// 8-bit PNG, marked as sRGB: RGBA with straight alpha, or RGB where every pixel is opaque.
/// @throws Error (write), or (limit) for more than largest_png_bytes
void write_png(const std::filesystem::path& path, ImageView<const Rgba8> image);

/// Any PNG; grey, palette and 16-bit pictures become RGBA8 (16 bits: the upper byte). Chunk checksums must be
/// right.
/// Allocates for one picture what its header announces; that is refused unless the compressed data, which
/// hold at most 1032 bytes in one, can fill it. @throws Error (read)
Image<Rgba8> read_png(const std::filesystem::path& path);

/// The same on bytes in memory. @param name how messages call them
std::vector<std::byte> encode_png(ImageView<const Rgba8> image);
Image<Rgba8> decode_png(std::span<const std::byte> bytes, const std::string& name);

/// The checksum of a PNG chunk: CRC-32 (ISO 3309) of its type and data.
unsigned png_checksum(std::span<const std::byte> bytes);

}  // namespace velum
