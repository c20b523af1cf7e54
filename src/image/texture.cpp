#include "texture.hpp"

#include <algorithm>
#include <glm/vec3.hpp>

#include "../base/contract.hpp"
#include "../base/floating_point.hpp"

namespace velum {
namespace {

glm::vec4 premultiplied(const Rgba8& texel) {
  const glm::vec4 straight = linear_from_srgb(texel);
  return {glm::vec3(straight) * straight.a, straight.a};
}

Image<glm::vec4> decoded(ImageView<const Rgba8> picture) {
  Image<glm::vec4> level(picture.width, picture.height);
  for (int y = 0; y < picture.height; ++y)
    std::transform(picture.row(y), picture.row(y) + picture.width, level.row(y), premultiplied);
  return level;
}

/// FNV-1a (Fowler, Noll & Vo 1991), a texel at a time.
std::uint64_t hash_of(ImageView<const Rgba8> picture) {
  std::uint64_t hash = 0xCBF29CE484222325u;
  const auto add = [&hash](std::uint64_t value) { hash = (hash ^ value) * 0x100000001B3u; };
  add(static_cast<std::uint64_t>(picture.width));
  add(static_cast<std::uint64_t>(picture.height));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const Rgba8& texel = picture.at(x, y);
      add(static_cast<std::uint64_t>(texel.r) << 24 | static_cast<std::uint64_t>(texel.g) << 16 |
          static_cast<std::uint64_t>(texel.b) << 8 | texel.a);
    }
  }
  return hash;
}

/// The texels that one of the next level covers along an axis: up to three, with weights of sum 1.
struct Covered {
  int first = 0;
  int count = 1;
  double weights[3] = {1.0, 0.0, 0.0};
};

/// An axis of size n shrinks to m = ⌊n/2⌋. For n = 2m+1, texel i covers the interval from i·n/m to (i+1)·n/m:
/// all of 2i+1 and the parts (m-i)/m of 2i and (i+1)/m of 2i+2 (Guthe & Heckbert 2005, "Non-Power-of-Two
/// Mipmapping").
Covered covered_by(int i, int size) {
  if (size == 1) return {};
  if (size % 2 == 0) return {2 * i, 2, {0.5, 0.5, 0.0}};
  const double n = size;
  const int m = size / 2;
  return {2 * i, 3, {(m - i) / n, m / n, (i + 1) / n}};
}

int halved(int size) {
  return std::max(1, size / 2);
}

glm::dvec4 mean_of(const Image<glm::vec4>& level, const Covered& columns, const Covered& rows) {
  glm::dvec4 mean(0.0);
  for (int y = 0; y < rows.count; ++y) {
    glm::dvec4 of_row(0.0);
    for (int x = 0; x < columns.count; ++x)
      of_row += glm::dvec4(level.at(columns.first + x, rows.first + y)) * columns.weights[x];
    mean += of_row * rows.weights[y];
  }
  return mean;
}

Image<glm::vec4> next_level(const Image<glm::vec4>& level) {
  Image<glm::vec4> smaller(halved(level.width()), halved(level.height()));
  for (int y = 0; y < smaller.height(); ++y) {
    const Covered rows = covered_by(y, level.height());
    for (int x = 0; x < smaller.width(); ++x)
      smaller.at(x, y) = glm::vec4(mean_of(level, covered_by(x, level.width()), rows));
  }
  return smaller;
}

bool all_opaque(ImageView<const Rgba8> picture) {
  for (int y = 0; y < picture.height; ++y) {
    const Rgba8* const row = picture.row(y);
    if (!std::all_of(row, row + picture.width, [](const Rgba8& texel) { return texel.a == 255; }))
      return false;
  }
  return true;
}

}  // namespace

Texture::Texture(ImageView<const Rgba8> picture) {
  VELUM_REQUIRE(!picture.is_empty(), {"width", picture.width}, {"height", picture.height});
  const FloatingPointScope scope;  // a caller's rounding mode changes no texel
  content_hash_ = hash_of(picture);
  is_opaque_ = all_opaque(picture);
  levels_.push_back(decoded(picture));
  while (levels_.back().width() > 1 || levels_.back().height() > 1)
    levels_.push_back(next_level(levels_.back()));
}

}  // namespace velum
