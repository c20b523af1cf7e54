#include "supersample_stage.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

#include "../base/error.hpp"
#include "../visibility/screen_segment.hpp"
#include "../visibility/tile_buffer.hpp"
#include "check_request.hpp"

namespace velum {
namespace {

void check_enlarged(float width, int times, const char* name) {
  if (width * static_cast<float>(times) <= widest_line) return;
  throw Error(ErrorKind::usage,
              std::to_string(width) + " pixels, drawn " + std::to_string(times) +
                  " times as large, are more than " + std::to_string(static_cast<int>(widest_line)),
              name, "give less, or a smaller factor of supersampling");
}

}  // namespace

void check_supersampling(const RenderSettings& settings) {
  const int times = settings.supersample;
  if (times < 1 || times > most_supersampling) {
    throw Error(ErrorKind::usage, "a picture cannot be rendered " + std::to_string(times) + " times as large",
                "supersample", "give a whole number from 1 (none) to " + std::to_string(most_supersampling));
  }
  if (times == 1) return;
  if (settings.width > largest_side / times || settings.height > largest_side / times) {
    throw Error(ErrorKind::usage,
                std::to_string(settings.width) + "x" + std::to_string(settings.height) +
                    " pixels, rendered " + std::to_string(times) +
                    " times as large, have a side of more than " + std::to_string(largest_side),
                "supersample", "give a smaller factor or a smaller picture, or use samples");
  }
  check_enlarged(settings.line_width, times, "line width");
  check_enlarged(settings.point_size, times, "point size");
}

RenderSettings enlarged(const RenderSettings& settings) {
  RenderSettings larger = settings;
  larger.width *= settings.supersample;
  larger.height *= settings.supersample;
  larger.line_width *= static_cast<float>(settings.supersample);
  larger.point_size *= static_cast<float>(settings.supersample);
  larger.supersample = 1;
  larger.crop.reset();
  return larger;
}

int supersample_band_height(int width) {
  constexpr int most_pixels = 1 << 22;
  return std::max(most_pixels / width / tile_size, 1) * tile_size;
}

void supersample(const RenderSettings& settings, const Rect& rect, const ImageView<Rgba8>& target,
                 Image<Rgba8>& band, const RenderColour& render) {
  Downsampler downsampler(settings.supersample_filter, settings.supersample, settings.width, settings.height,
                          rect, target);
  const Rect& source = downsampler.source();
  const int most = supersample_band_height(source.width);
  for (int top = 0; top < source.height; top += most) {
    const int height = std::min(most, source.height - top);
    band.resize(source.width, height);
    render({source.left, source.top + top, source.width, height}, band.view(),
           static_cast<double>(top) / source.height, static_cast<double>(top + height) / source.height);
    for (int y = 0; y < height; ++y) downsampler.add_row(band.row(y));
  }
}

}  // namespace velum
