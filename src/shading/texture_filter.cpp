#include "texture_filter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

#include "../base/elementary.hpp"

namespace velum {
namespace {

using Wraps = std::array<TextureWrap, 2>;

/// The coordinate in the first period (0…1, mirrored 0…2) or on the picture's edge.
double in_first_period(double coordinate, TextureWrap wrap) {
  if (!(coordinate - coordinate == 0.0)) return 0.0;
  if (wrap == TextureWrap::repeat) return coordinate - elementary::floor(coordinate);
  if (wrap == TextureWrap::mirror) return coordinate - 2.0 * elementary::floor(coordinate * 0.5);
  return std::clamp(coordinate, 0.0, 1.0);
}

/// The texel that stands at place i of the axis, 0 … size-1.
/// @pre -1 ≤ i ≤ 2·size + 1
int wrapped(int i, int size, TextureWrap wrap) {
  if (wrap == TextureWrap::clamp) return std::clamp(i, 0, size - 1);
  if (wrap == TextureWrap::repeat) return (i + size) % size;
  const int in_period = (i + 2 * size) % (2 * size);
  return in_period < size ? in_period : 2 * size - 1 - in_period;
}

/// @param row  counted from below, as texture coordinates do
glm::dvec4 texel(const Image<glm::vec4>& level, int column, int row, const Wraps& wrap) {
  const int x = wrapped(column, level.width(), wrap[0]);
  const int y = wrapped(row, level.height(), wrap[1]);
  return glm::dvec4(level.at(x, level.height() - 1 - y));
}

glm::dvec4 nearest(const Image<glm::vec4>& level, const glm::dvec2& at, const Wraps& wrap) {
  const double x = in_first_period(at.x, wrap[0]) * level.width();
  const double y = in_first_period(at.y, wrap[1]) * level.height();
  return texel(level, static_cast<int>(x), static_cast<int>(y), wrap);
}

glm::dvec4 bilinear(const Image<glm::vec4>& level, const glm::dvec2& at, const Wraps& wrap) {
  const double x = in_first_period(at.x, wrap[0]) * level.width() - 0.5;
  const double y = in_first_period(at.y, wrap[1]) * level.height() - 0.5;
  const double column = elementary::floor(x), row = elementary::floor(y);
  const double right = x - column, up = y - row;
  const int i = static_cast<int>(column), j = static_cast<int>(row);
  const glm::dvec4 lower = texel(level, i, j, wrap) * (1.0 - right) + texel(level, i + 1, j, wrap) * right;
  const glm::dvec4 upper =
      texel(level, i, j + 1, wrap) * (1.0 - right) + texel(level, i + 1, j + 1, wrap) * right;
  return lower * (1.0 - up) + upper * up;
}

/// A level of detail: this level and the share of the next one.
struct Detail {
  int level = 0;
  double next = 0.0;
};

/// @param length  of a round footprint, texels
Detail detail_for(const Texture& texture, double length) {
  constexpr double per_ln_2 = 1.44269504088896340736;
  if (!(length > 1.0)) return {};
  const double lambda = elementary::log(length) * per_ln_2;
  const int last = texture.level_count() - 1;
  if (lambda >= last) return {last, 0.0};
  const int level = static_cast<int>(lambda);
  return {level, lambda - level};
}

glm::dvec4 trilinear(const Texture& texture, const Detail& detail, const glm::dvec2& at, const Wraps& wrap) {
  const glm::dvec4 finer = bilinear(texture.level(detail.level), at, wrap);
  if (detail.next == 0.0) return finer;
  return finer * (1.0 - detail.next) + bilinear(texture.level(detail.level + 1), at, wrap) * detail.next;
}

/// The ellipse that a pixel covers on the picture.
struct Footprint {
  double longer = 0.0;    ///< axis in texels
  double shorter = 0.0;   ///< axis in texels
  glm::dvec2 along{0.0};  ///< the longer axis in texture coordinates
};

/// Singular values and first direction of the matrix with columns dx, dy, from its product with its
/// transpose.
Footprint footprint_of(const Texture& texture, const TextureLookup& lookup) {
  const glm::dvec2 size(texture.width(), texture.height());
  const glm::dvec2 a = lookup.dx * size, b = lookup.dy * size;
  const double uv = a.x * a.y + b.x * b.y;
  const double mean = 0.5 * (a.x * a.x + b.x * b.x + a.y * a.y + b.y * b.y);
  const double half_difference = 0.5 * (a.x * a.x + b.x * b.x - a.y * a.y - b.y * b.y);
  const double root = std::sqrt(half_difference * half_difference + uv * uv);
  Footprint footprint;
  footprint.longer = std::sqrt(mean + root);
  if (!(footprint.longer > 0.0)) return footprint;
  footprint.shorter = std::abs(a.x * b.y - a.y * b.x) / footprint.longer;
  const glm::dvec2 direction = half_difference >= 0.0 ? glm::dvec2(half_difference + root, uv)
                                                      : glm::dvec2(uv, root - half_difference);
  const double length = std::sqrt(direction.x * direction.x + direction.y * direction.y);
  if (length > 0.0) footprint.along = direction * (footprint.longer / length) / size;
  return footprint;
}

/// The variance of what a probe of length l sees is l²/4, the box of its level and the tent between texels
/// together; the probes' places add what the longer axis needs beyond that.
glm::dvec4 probed(const Texture& texture, const Wraps& wrap, const glm::dvec2& at,
                  const Footprint& footprint) {
  constexpr double most_uneven = 16.0;
  const double length = std::max({footprint.shorter, footprint.longer / most_uneven, 1.0});
  const Detail detail = detail_for(texture, length);
  const glm::dvec4 centre = trilinear(texture, detail, at, wrap);
  if (!(footprint.longer > length)) return centre;
  // Two standard deviations to each side; diagonal patterns would alias in steps as long as a probe.
  const double reach = std::sqrt(footprint.longer * footprint.longer - length * length);
  const int steps = static_cast<int>(elementary::ceil(1.5 * reach / length));
  const glm::dvec2 step = footprint.along * (reach / footprint.longer / steps);
  glm::dvec4 sum = centre;
  double weights = 1.0;
  for (int i = 1; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const double weight = elementary::exp(-2.0 * share * share);
    const glm::dvec2 offset = step * static_cast<double>(i);
    sum += (trilinear(texture, detail, at - offset, wrap) + trilinear(texture, detail, at + offset, wrap)) *
           weight;
    weights += 2.0 * weight;
  }
  return sum / weights;
}

glm::dvec4 filtered_by_area(const Texture& texture, const Wraps& wrap, const TextureLookup& lookup) {
  // Far beyond the largest picture, and where the derivatives have no value, only the mean is left.
  constexpr double largest = 0x1p40;
  const Footprint footprint = footprint_of(texture, lookup);
  if (!(footprint.longer < largest)) return glm::dvec4(texture.level(texture.level_count() - 1).at(0, 0));
  return probed(texture, wrap, lookup.at, footprint);
}

glm::vec4 straight(const glm::dvec4& premultiplied, bool is_opaque) {
  if (is_opaque) return {glm::vec3(premultiplied), 1.0f};
  if (!(premultiplied.a > 0.0)) return glm::vec4(0.0f);
  return {glm::vec3(glm::dvec3(premultiplied) / premultiplied.a), static_cast<float>(premultiplied.a)};
}

}  // namespace

glm::vec4 filtered(const Texture& texture, const Wraps& wrap, TextureFilter filter,
                   const TextureLookup& lookup) {
  if (filter == TextureFilter::trilinear)
    return straight(filtered_by_area(texture, wrap, lookup), texture.is_opaque());
  const Image<glm::vec4>& picture = texture.level(0);
  return straight(filter == TextureFilter::nearest ? nearest(picture, lookup.at, wrap)
                                                   : bilinear(picture, lookup.at, wrap),
                  texture.is_opaque());
}

}  // namespace velum
