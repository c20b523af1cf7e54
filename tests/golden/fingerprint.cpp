#include "fingerprint.hpp"

#include <nettle/sha2.h>

#include <bit>

namespace golden {
namespace {

static_assert(std::endian::native == std::endian::little, "the hashes are of little-endian buffers");

template <typename T>
std::string sha256(const velum::Image<T>& image) {
  sha256_ctx context;
  sha256_init(&context);
  const std::size_t row_bytes = static_cast<std::size_t>(image.width()) * sizeof(T);
  for (int y = 0; y < image.height(); ++y) {
    sha256_update(&context, row_bytes, reinterpret_cast<const std::uint8_t*>(image.row(y)));
  }
  std::uint8_t digest[SHA256_DIGEST_SIZE];
  sha256_digest(&context, sizeof digest, digest);
  std::string text;
  for (const std::uint8_t byte : digest) {
    constexpr char digits[] = "0123456789abcdef";
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

}  // namespace

std::string fingerprint(const velum::Picture& picture) {
  return "colour=" + sha256(picture.colour) + " depth=" + sha256(picture.depth) +
         " objects=" + sha256(picture.object_id) + " triangles=" + sha256(picture.triangle_id);
}

}  // namespace golden
