#include "wide_ray.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../../base/double_bits.hpp"

namespace velum {
namespace {

constexpr double largest_inverse = 0x1.0p40;
/// Within these, nothing in the kernels overflows, and what underflows is far below the margin.
constexpr double smallest_reach = 0x1.0p-80, largest_reach = 0x1.0p80;
constexpr double smallest_scale = 0x1.0p-500, largest_scale = 0x1.0p500;

/// PreparedRay::margin is 2^-48 of the reach.
constexpr double reach_per_margin = 0x1.0p48;

void set_axis(const PreparedRay& ray, double scale, double reach, int axis, WideRay& wide) {
  const auto i = static_cast<std::size_t>(axis);
  const double origin = ray.ray.origin[axis];
  const double margin = 0x1.0p-21 * reach + 0x1.0p-22 * std::fabs(origin);
  const double inverse = std::min(std::max(ray.inverse[axis] * scale, -largest_inverse), largest_inverse);
  const double forwards = elementary::with_sign_of(margin, inverse);  // signs are no branches: they vary
  wide.near_from[i] = static_cast<float>(origin + forwards);
  wide.far_from[i] = static_cast<float>(origin - forwards);
  wide.inverse[i] = static_cast<float>(inverse);
  const auto is_back = static_cast<std::uint32_t>(inverse < 0.0);
  wide.near_row[i] = static_cast<std::uint32_t>(axis) + 3 * is_back;
  wide.far_row[i] = static_cast<std::uint32_t>(axis) + 3 - 3 * is_back;
}

}  // namespace

double scale_of(const PreparedRay& ray) {
  return std::fabs(ray.ray.direction[ray.kz]);
}

float rounded_up(double v) {
  constexpr double largest = std::numeric_limits<float>::max() / 2.0f;
  if (v > largest) return std::numeric_limits<float>::infinity();
  const auto f = static_cast<float>(std::max(v, -largest));
  return f + (std::fabs(f) * 0x1.0p-23f + std::numeric_limits<float>::min());
}

float rounded_down(double v) {
  return -rounded_up(-v);
}

bool make_wide_ray(const PreparedRay& ray, WideRay& wide) {
  const double scale = scale_of(ray);
  const double reach = ray.margin * reach_per_margin;
  const glm::dvec3& o = ray.ray.origin;
  const double farthest = std::max({reach, std::fabs(o.x), std::fabs(o.y), std::fabs(o.z)});
  if (!(scale > smallest_scale && scale < largest_scale)) return false;
  if (!(reach > smallest_reach && farthest < largest_reach)) return false;
  for (int axis = 0; axis < 3; ++axis) set_axis(ray, scale, reach, axis, wide);
  wide.lower = rounded_down(ray.range.lower * scale);
  wide.upper = rounded_up(ray.range.upper * scale);
  const int axes[3] = {ray.kx, ray.ky, ray.kz};
  for (std::size_t i = 0; i < 3; ++i) {
    wide.origin[i] = o[axes[i]];
    wide.axis[i] = static_cast<std::uint32_t>(axes[i]);
  }
  wide.shear_x = ray.shear_x;
  wide.shear_y = ray.shear_y;
  return true;
}

}  // namespace velum
