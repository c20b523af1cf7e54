#include "depth_resolution.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "../base/floating_point.hpp"

namespace velum {
namespace {

/// Reversed depth as a function of distance. Perspective: r = (1/d - 1/far) / (1/near - 1/far);
/// parallel: r = (far - d) / (far - near).
struct DepthMapping {
  bool is_perspective;
  double near, far;

  explicit DepthMapping(const Camera& camera)
      : is_perspective(camera.is_perspective()), near(camera.near()), far(camera.far()) {}

  double inverse_range() const { return 1.0 / near - 1.0 / far; }

  double reversed_depth(double distance) const {
    if (is_perspective) return (1.0 / distance - 1.0 / far) / inverse_range();
    return (far - distance) / (far - near);
  }

  /// How far the surface of r_far lies behind that of r_near, without the cancellation of two distances.
  double distance_between(double r_near, double r_far) const {
    if (!is_perspective) return (r_near - r_far) * (far - near);
    const double inverse_near = 1.0 / far + r_near * inverse_range();
    const double inverse_far = 1.0 / far + r_far * inverse_range();
    return (r_near - r_far) * inverse_range() / inverse_near / inverse_far;
  }
};

/// The first float in bit order from `bits` + 1 up to that of 1 whose stored value differs from `stored`; the
/// bits of 1 if there is none. Stored values are monotone, so bisection finds it.
std::uint32_t next_nearer(DepthFormat format, std::uint32_t bits, float stored) {
  std::uint32_t same = bits;
  std::uint32_t other = std::bit_cast<std::uint32_t>(1.0f);
  while (other - same > 1) {
    const std::uint32_t middle = same + (other - same) / 2;
    (stored_depth(format, std::bit_cast<float>(middle)) == stored ? same : other) = middle;
  }
  return other;
}

/// The same downwards, to the bits of 0.
std::uint32_t next_farther(DepthFormat format, std::uint32_t bits, float stored) {
  std::uint32_t same = bits;
  std::uint32_t other = 0;
  while (same - other > 1) {
    const std::uint32_t middle = other + (same - other) / 2;
    (stored_depth(format, std::bit_cast<float>(middle)) == stored ? same : other) = middle;
  }
  return other;
}

}  // namespace

double depth_resolution_at(const Camera& camera, DepthFormat format, double metric_depth) {
  const FloatingPointScope floating_point;
  const DepthMapping mapping(camera);
  const double distance = std::clamp(metric_depth, mapping.near, mapping.far);
  const auto r = static_cast<float>(std::clamp(mapping.reversed_depth(distance), 0.0, 1.0));
  const float stored = stored_depth(format, r);
  const auto bits = std::bit_cast<std::uint32_t>(r);
  if (stored > 0.0f) {
    const float farther = std::bit_cast<float>(next_farther(format, bits, stored));
    return mapping.distance_between(stored, stored_depth(format, farther));
  }
  const float nearer = std::bit_cast<float>(next_nearer(format, bits, stored));
  return mapping.distance_between(stored_depth(format, nearer), stored);
}

}  // namespace velum
