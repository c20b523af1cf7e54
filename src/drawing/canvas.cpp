#include "canvas.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "../base/contract.hpp"
#include "../base/elementary.hpp"
#include "../base/floating_point.hpp"
#include "font.hpp"

namespace velum {
namespace {

bool is_finite(const glm::dvec2& p) {
  return p.x - p.x == 0.0 && p.y - p.y == 0.0;
}

double length(const glm::dvec2& v) {
  return std::sqrt(v.x * v.x + v.y * v.y);
}

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 along = b - a;
  const double squared = glm::dot(along, along);
  const double t = squared > 0.0 ? std::clamp(glm::dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  return length(p - (a + along * t));
}

/// The share of a pixel inside a shape whose border is `inside` pixels away: a ramp one pixel wide.
double ramp(double inside) {
  return std::clamp(inside + 0.5, 0.0, 1.0);
}

bool is_inside(const glm::dvec2& p, std::span<const glm::dvec2> corners) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2& a = corners[i];
    const glm::dvec2& b = corners[i + 1 < corners.size() ? i + 1 : 0];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

constexpr int samples = 4;

double covered_share(int x, int y, std::span<const glm::dvec2> corners) {
  int hits = 0;
  for (int j = 0; j < samples; ++j) {
    for (int i = 0; i < samples; ++i) {
      hits += is_inside({x + (i + 0.5) / samples, y + (j + 0.5) / samples}, corners);
    }
  }
  return hits / static_cast<double>(samples * samples);
}

int clamped_floor(double v, int low, int high) {
  return static_cast<int>(
      elementary::floor(std::clamp(v, static_cast<double>(low), static_cast<double>(high))));
}

glm::vec4 premultiplied(const Rgba8& colour) {
  const glm::vec4 linear = linear_from_srgb(colour);
  return {linear.x * linear.w, linear.y * linear.w, linear.z * linear.w, linear.w};
}

}  // namespace

Canvas::Canvas(int width, int height, const Rgba8& background)
    : pixels_(width, height, premultiplied(background)) {}

Canvas::Bounds Canvas::bounds_of(const glm::dvec2& low, const glm::dvec2& high) const {
  return {clamped_floor(low.x - 1.0, 0, width()), clamped_floor(low.y - 1.0, 0, height()),
          clamped_floor(high.x + 2.0, 0, width()), clamped_floor(high.y + 2.0, 0, height())};
}

void Canvas::blend(int x, int y, const glm::vec4& colour, double coverage) {
  const glm::vec4 front = colour * static_cast<float>(coverage);
  glm::vec4& pixel = pixels_.at(x, y);
  pixel = front + pixel * (1.0f - front.w);
}

void Canvas::line(const glm::dvec2& a, const glm::dvec2& b, double thickness, const Rgba8& colour) {
  const FloatingPointScope floating_point;
  if (!is_finite(a) || !is_finite(b)) return;
  const double half = 0.5 * thickness;
  const glm::vec4 ink = premultiplied(colour);
  const Bounds box = bounds_of(glm::min(a, b) - half, glm::max(a, b) + half);
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      const double coverage = ramp(half - distance_to_segment({x + 0.5, y + 0.5}, a, b));
      if (coverage > 0.0) blend(x, y, ink, std::min(coverage, thickness));
    }
  }
}

void Canvas::dashed_line(const glm::dvec2& a, const glm::dvec2& b, double thickness, double dash,
                         const Rgba8& colour) {
  const FloatingPointScope floating_point;
  VELUM_REQUIRE(dash > 0.0, {"dash", dash});
  if (!is_finite(a) || !is_finite(b)) return;
  // A line far longer than the picture keeps a bounded number of dashes.
  const double total = length(b - a);
  const double step = std::max(dash, total / 10000.0);
  for (double from = 0.0; from < total; from += 2.0 * step) {
    const double to = std::min(from + step, total);
    line(a + (b - a) * (from / total), a + (b - a) * (to / total), thickness, colour);
  }
}

void Canvas::outline(std::span<const glm::dvec2> corners, double thickness, const Rgba8& colour) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    line(corners[i], corners[i + 1 < corners.size() ? i + 1 : 0], thickness, colour);
  }
}

void Canvas::disc(const glm::dvec2& centre, double radius, const Rgba8& colour) {
  const FloatingPointScope floating_point;
  line(centre, centre, 2.0 * radius, colour);
}

void Canvas::ring(const glm::dvec2& centre, double radius, double thickness, const Rgba8& colour) {
  const FloatingPointScope floating_point;
  if (!is_finite(centre)) return;
  const glm::vec4 ink = premultiplied(colour);
  const double outer = radius + 0.5 * thickness;
  const Bounds box = bounds_of(centre - outer, centre + outer);
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      const double from_ring = std::abs(length(glm::dvec2(x + 0.5, y + 0.5) - centre) - radius);
      const double coverage = ramp(0.5 * thickness - from_ring);
      if (coverage > 0.0) blend(x, y, ink, coverage);
    }
  }
}

void Canvas::polygon(std::span<const glm::dvec2> corners, const Rgba8& colour) {
  const FloatingPointScope floating_point;
  if (corners.size() < 3 || !std::all_of(corners.begin(), corners.end(), is_finite)) return;
  const glm::vec4 ink = premultiplied(colour);
  glm::dvec2 low = corners[0];
  glm::dvec2 high = corners[0];
  for (const glm::dvec2& corner : corners) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  const Bounds box = bounds_of(low, high);
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      const double coverage = covered_share(x, y, corners);
      if (coverage > 0.0) blend(x, y, ink, coverage);
    }
  }
}

void Canvas::rectangle(int left, int top, int width, int height, const Rgba8& colour) {
  const glm::vec4 ink = premultiplied(colour);
  for (int y = std::max(top, 0); y < std::min(top + height, this->height()); ++y) {
    for (int x = std::max(left, 0); x < std::min(left + width, this->width()); ++x) blend(x, y, ink, 1.0);
  }
}

void Canvas::letter(int left, int top, char character, int scale, const Rgba8& colour) {
  const Glyph& glyph = glyph_of(character);
  for (int column = 0; column < glyph_width; ++column) {
    for (int row = 0; row < glyph_height; ++row) {
      if ((glyph[static_cast<std::size_t>(column)] >> row & 1) == 0) continue;
      rectangle(left + column * scale, top + row * scale, scale, scale, colour);
    }
  }
}

void Canvas::text(const glm::dvec2& at, std::string_view text, int scale, const Rgba8& colour,
                  TextAnchor anchor) {
  const FloatingPointScope floating_point;
  VELUM_REQUIRE(scale >= 1, {"scale", scale});
  if (!is_finite(at)) return;
  const double share = anchor == TextAnchor::left ? 0.0 : (anchor == TextAnchor::middle ? 0.5 : 1.0);
  // Far outside nothing is seen, and whole numbers have an end.
  const int far = 1 << 24;
  int left = clamped_floor(at.x - share * text_width(text, scale) + 0.5, -far, far);
  const int top = clamped_floor(at.y + 0.5, -far, far);
  for (const char character : text) {
    letter(left, top, character, scale, colour);
    left += glyph_advance * scale;
  }
}

int Canvas::text_width(std::string_view text, int scale) {
  return text.empty() ? 0 : (static_cast<int>(text.size()) * glyph_advance - 1) * scale;
}

Image<Rgba8> Canvas::picture() const {
  const FloatingPointScope floating_point;
  Image<Rgba8> result(width(), height());
  for (int y = 0; y < height(); ++y) {
    for (int x = 0; x < width(); ++x) {
      const glm::vec4& p = pixels_.at(x, y);
      const float scale = p.w > 0.0f ? 1.0f / p.w : 0.0f;
      result.at(x, y) = srgb_from_linear(glm::vec4(p.x * scale, p.y * scale, p.z * scale, p.w));
    }
  }
  return result;
}

}  // namespace velum
