#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <vector>

#include "colour.hpp"
#include "image.hpp"

namespace velum {

/// NPY 1.0, little-endian, C order, top row first: shape (height, width), or (height, width, 3) for vec3 and
/// (height, width, 4) for Rgba8 (NumPy Enhancement Proposal 1, 2007). @throws Error (write)
void write_npy(const std::filesystem::path& path, ImageView<const float> image);
void write_npy(const std::filesystem::path& path, ImageView<const std::uint32_t> image);
void write_npy(const std::filesystem::path& path, ImageView<const glm::vec3> image);
void write_npy(const std::filesystem::path& path, ImageView<const Rgba8> image);

/// The same in memory.
std::vector<std::byte> encode_npy(ImageView<const float> image);
std::vector<std::byte> encode_npy(ImageView<const std::uint32_t> image);
std::vector<std::byte> encode_npy(ImageView<const glm::vec3> image);
std::vector<std::byte> encode_npy(ImageView<const Rgba8> image);

}  // namespace velum
