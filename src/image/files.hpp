#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "colour.hpp"
#include "image.hpp"

namespace velum {

/// Writers. A file appears whole or not at all (temporary file in the same folder, then rename); "-" is
/// standard output.
/// @throws Error (write) with the path and the system's reason

/// 8-bit RGBA PNG, sRGB; opaque pictures are written as RGB.
void write_png(const std::filesystem::path& path, ImageView<const Rgba8> image);
/// Binary PPM (P6), 8-bit; alpha is dropped (straight colour as it stands).
void write_ppm(const std::filesystem::path& path, ImageView<const Rgba8> image);
/// PFM, little-endian, one channel ("Pf") or three ("PF"); rows bottom to top as the format has it.
void write_pfm(const std::filesystem::path& path, ImageView<const float> image);
void write_pfm(const std::filesystem::path& path, ImageView<const glm::vec3> image);
/// NPY 1.0, little-endian, C order, top row first: shape (height, width) or (height, width, channels).
void write_npy(const std::filesystem::path& path, ImageView<const float> image);
void write_npy(const std::filesystem::path& path, ImageView<const std::uint32_t> image);
void write_npy(const std::filesystem::path& path, ImageView<const glm::vec3> image);
void write_npy(const std::filesystem::path& path, ImageView<const Rgba8> image);

/// Readers. @throws Error (read) with the path, what is wrong and what to do; never crash, hang or allocate
/// more than the header honestly announces and the file can hold
Image<Rgba8> read_png(const std::filesystem::path& path);
Image<Rgba8> read_ppm(const std::filesystem::path& path);
Image<float> read_pfm(const std::filesystem::path& path);          ///< one channel
Image<glm::vec3> read_pfm_rgb(const std::filesystem::path& path);  ///< three channels

/// Writes bytes whole or not at all; "-" is standard output. @throws Error (write)
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
/// Reads a whole file; "-" is standard input. @throws Error (read)
std::vector<std::byte> read_file(const std::filesystem::path& path);

}  // namespace velum
