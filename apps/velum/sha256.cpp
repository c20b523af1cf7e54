#include "sha256.hpp"

#include <nettle/sha2.h>

#include <array>
#include <bit>
#include <vector>

namespace velum_app {
namespace {

using Bytes = std::vector<std::uint8_t>;

void append(Bytes& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void append(Bytes& bytes, float value) {
  append(bytes, std::bit_cast<std::uint32_t>(value));
}

void append(Bytes& bytes, const velum::Rgba8& colour) {
  bytes.insert(bytes.end(), {colour.r, colour.g, colour.b, colour.a});
}

std::string hexadecimal(const std::array<std::uint8_t, SHA256_DIGEST_SIZE>& digest) {
  std::string text;
  for (const std::uint8_t byte : digest) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

template <typename T>
std::string digest_rows(velum::ImageView<const T> image) {
  sha256_ctx context;
  sha256_init(&context);
  Bytes row;
  for (int y = 0; y < image.height; ++y) {
    row.clear();
    for (int x = 0; x < image.width; ++x) append(row, image.at(x, y));
    sha256_update(&context, row.size(), row.data());
  }
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest;
  sha256_digest(&context, digest.size(), digest.data());
  return hexadecimal(digest);
}

}  // namespace

std::string sha256_of(velum::ImageView<const velum::Rgba8> image) {
  return digest_rows(image);
}

std::string sha256_of(velum::ImageView<const float> image) {
  return digest_rows(image);
}

std::string sha256_of(velum::ImageView<const std::uint32_t> image) {
  return digest_rows(image);
}

}  // namespace velum_app
