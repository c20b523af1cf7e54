#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "colour.hpp"
#include "image.hpp"

namespace velum {

/// Binary PPM (P6), 8-bit; alpha is dropped (straight colour as it stands). @throws Error (write)
void write_ppm(const std::filesystem::path& path, ImageView<const Rgba8> image);

/// Binary PPM (P6) with the largest value 255; comments are skipped; opaque. @throws Error (read)
Image<Rgba8> read_ppm(const std::filesystem::path& path);

/// The same on bytes in memory. @param name how messages call them
std::vector<std::byte> encode_ppm(ImageView<const Rgba8> image);
Image<Rgba8> decode_ppm(std::span<const std::byte> bytes, const std::string& name);

}  // namespace velum
