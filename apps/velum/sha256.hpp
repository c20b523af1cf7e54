#pragma once

#include <cstdint>
#include <string>
#include <velum/velum.hpp>

namespace velum_app {

/// SHA-256 of an image's pixels in hexadecimal: elements little-endian, rows without padding, top row first.
std::string sha256_of(velum::ImageView<const velum::Rgba8> image);
std::string sha256_of(velum::ImageView<const float> image);
std::string sha256_of(velum::ImageView<const std::uint32_t> image);

}  // namespace velum_app
