#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "image.hpp"

namespace velum {

/// PFM, little-endian, one channel ("Pf") or three ("PF"); rows bottom to top as the format has it
/// (Debevec, "HDRShop User Manual", 2001). @throws Error (write)
void write_pfm(const std::filesystem::path& path, ImageView<const float> image);
void write_pfm(const std::filesystem::path& path, ImageView<const glm::vec3> image);

/// Both byte orders; the size of the header's scale is ignored, its sign is the byte order. Every bit pattern
/// is kept, infinities and NaN too. @throws Error (read), also when the number of channels is the other one
Image<float> read_pfm(const std::filesystem::path& path);          ///< one channel
Image<glm::vec3> read_pfm_rgb(const std::filesystem::path& path);  ///< three channels

/// The same on bytes in memory. @param name how messages call them
std::vector<std::byte> encode_pfm(ImageView<const float> image);
std::vector<std::byte> encode_pfm(ImageView<const glm::vec3> image);
Image<float> decode_pfm(std::span<const std::byte> bytes, const std::string& name);
Image<glm::vec3> decode_pfm_rgb(std::span<const std::byte> bytes, const std::string& name);

}  // namespace velum
