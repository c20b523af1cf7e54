#include "downsample.hpp"

#include <algorithm>
#include <glm/vec3.hpp>

#include "../base/contract.hpp"
#include "../base/elementary.hpp"

namespace velum {
namespace {

/// k(x) of Mitchell & Netravali 1988, equation 8, for B = C = 1/3, times 18.
double mitchell_value(double x) {
  if (x < 1.0) return (21.0 * x - 36.0) * x * x + 16.0;
  if (x < 2.0) return ((-7.0 * x + 36.0) * x - 60.0) * x + 32.0;
  return 0.0;
}

glm::vec4 premultiplied(const Rgba8& pixel) {
  const glm::vec4 straight = linear_from_srgb(pixel);
  return {glm::vec3(straight) * straight.w, straight.w};
}

/// To 0 … most; NaN cannot be.
float clamped(float value, float most) {
  return value > 0.0f ? (value < most ? value : most) : 0.0f;
}

Rgba8 encoded(const glm::vec4& sum) {
  const float alpha = clamped(sum.w, 1.0f);
  if (!(alpha > 0.0f)) return srgb_from_linear(glm::vec4(0.0f));
  return srgb_from_linear(
      {clamped(sum.x, alpha) / alpha, clamped(sum.y, alpha) / alpha, clamped(sum.z, alpha) / alpha, alpha});
}

}  // namespace

double filter_value(DownsampleFilter filter, double x) {
  const double distance = x < 0.0 ? -x : x;
  switch (filter) {
    case DownsampleFilter::box:
      return distance < 0.5 ? 1.0 : 0.0;
    case DownsampleFilter::tent:
      return distance < 1.0 ? 1.0 - distance : 0.0;
    case DownsampleFilter::mitchell:
      return mitchell_value(distance) / 18.0;
  }
  return 0.0;
}

FilterTaps taps_of(DownsampleFilter filter, int scale, int pixel, int size) {
  const auto in_small = [scale](int i) { return (i + 0.5) / scale; };
  const double centre = pixel + 0.5;
  const int reach = static_cast<int>(elementary::floor(radius_of(filter) * scale + 0.5));
  // The pixels whose centres are nearer than the radius lie between these.
  const int middle = pixel * scale + scale / 2;
  int first = std::max(middle - reach, 0);
  int end = std::min(middle + reach + 1, size * scale);
  while (filter_value(filter, in_small(first) - centre) == 0.0) ++first;
  while (filter_value(filter, in_small(end - 1) - centre) == 0.0) --end;
  double sum = 0.0;
  for (int i = first; i < end; ++i) sum += filter_value(filter, in_small(i) - centre);
  FilterTaps taps;
  taps.first = first;
  for (int i = first; i < end; ++i)
    taps.weights.push_back(static_cast<float>(filter_value(filter, in_small(i) - centre) / sum));
  return taps;
}

Downsampler::Downsampler(DownsampleFilter filter, int scale, int width, int height, const Rect& part,
                         const ImageView<Rgba8>& target)
    : filter_(filter), scale_(scale), height_(height), part_(part), target_(target) {
  VELUM_REQUIRE(scale >= 1, {"scale", scale});
  VELUM_REQUIRE(intersect(part, {0, 0, width, height}) == part && !part.is_empty(), {"left", part.left},
                {"top", part.top}, {"width", part.width}, {"height", part.height});
  for (int x = part.left; x < part.right(); ++x) columns_.push_back(taps_of(filter, scale, x, width));
  const int top = taps_of(filter, scale, part.top, height).first;
  const int bottom = taps_of(filter, scale, part.bottom() - 1, height).end();
  source_ = {columns_.front().first, top, columns_.back().end() - columns_.front().first, bottom - top};
  next_row_ = top;
  next_open_ = part.top;
  decoded_.resize(static_cast<std::size_t>(source_.width));
  filtered_.resize(static_cast<std::size_t>(part.width));
}

void Downsampler::add_row(const Rgba8* row) {
  VELUM_REQUIRE(next_row_ < source_.bottom(), {"rows", source_.height});
  open_rows();
  filter_row(row);
  for (OpenRow& open : open_) {
    const float weight = open.taps.weights[static_cast<std::size_t>(next_row_ - open.taps.first)];
    for (std::size_t x = 0; x < filtered_.size(); ++x) open.sum[x] += filtered_[x] * weight;
  }
  ++next_row_;
  std::erase_if(open_, [this](const OpenRow& open) {
    if (open.taps.end() > next_row_) return false;
    write(open);
    return true;
  });
}

/// Those that the next row of the source is the first to add to.
void Downsampler::open_rows() {
  for (; next_open_ < part_.bottom(); ++next_open_) {
    FilterTaps taps = taps_of(filter_, scale_, next_open_, height_);
    if (taps.first > next_row_) return;
    open_.push_back({next_open_, std::move(taps), std::vector<glm::vec4>(filtered_.size(), glm::vec4(0.0f))});
  }
}

void Downsampler::filter_row(const Rgba8* row) {
  for (std::size_t i = 0; i < decoded_.size(); ++i) decoded_[i] = premultiplied(row[i]);
  for (std::size_t x = 0; x < columns_.size(); ++x) {
    const FilterTaps& taps = columns_[x];
    const glm::vec4* const from = decoded_.data() + (taps.first - source_.left);
    glm::vec4 sum(0.0f);
    for (std::size_t i = 0; i < taps.weights.size(); ++i) sum += from[i] * taps.weights[i];
    filtered_[x] = sum;
  }
}

void Downsampler::write(const OpenRow& row) const {
  Rgba8* const out = target_.row(row.y - part_.top);
  for (std::size_t x = 0; x < row.sum.size(); ++x) out[x] = encoded(row.sum[x]);
}

}  // namespace velum
