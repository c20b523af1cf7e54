#include "check_request.hpp"

#include <string>

#include "../base/error.hpp"
#include "../visibility/sample_positions.hpp"
#include "../visibility/screen_segment.hpp"

namespace velum {
namespace {

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

void check_width(float width, const char* name) {
  if (width >= 1.0f && width <= widest_line) return;
  throw Error(ErrorKind::usage, std::to_string(width) + " pixels cannot be drawn", name,
              "give a number from 1 to " + std::to_string(static_cast<int>(widest_line)));
}

template <typename T>
void check_view(const ImageView<T>& view, const char* name, const Rect& rect) {
  if (view.data == nullptr) return;
  if (view.width != rect.width || view.height != rect.height || view.stride < view.width) {
    throw Error(ErrorKind::usage,
                "the view is " + size_text(view.width, view.height) + " with stride " +
                    std::to_string(view.stride) + ", the picture is " + size_text(rect.width, rect.height),
                std::string("PictureTarget::") + name, "give a view of the picture's (or crop's) size");
  }
}

}  // namespace

Rect requested_rect(const RenderSettings& settings) {
  const auto is_size = [](int side) { return side >= 1 && side <= largest_side; };
  if (!is_size(settings.width) || !is_size(settings.height)) {
    throw Error(ErrorKind::usage,
                "a picture of " + size_text(settings.width, settings.height) + " pixels cannot be made",
                "size", "give a width and a height from 1 to " + std::to_string(largest_side));
  }
  const Rect whole{0, 0, settings.width, settings.height};
  if (!settings.crop) return whole;
  const Rect& crop = *settings.crop;
  // Compared without sums, which could overflow.
  const bool is_inside = crop.left >= 0 && crop.top >= 0 && crop.width >= 1 && crop.height >= 1 &&
                         crop.left < settings.width && crop.top < settings.height &&
                         crop.width <= settings.width - crop.left &&
                         crop.height <= settings.height - crop.top;
  if (!is_inside) {
    throw Error(ErrorKind::usage,
                "the rectangle " + std::to_string(crop.left) + "," + std::to_string(crop.top) + "," +
                    std::to_string(crop.width) + "," + std::to_string(crop.height) +
                    " is not inside the picture of " + size_text(settings.width, settings.height),
                "crop", "give left, top, width and height of a part of the picture");
  }
  return crop;
}

void check_pixel(const Rect& rect, int x, int y) {
  if (rect.contains(x, y)) return;
  throw Error(ErrorKind::usage,
              "the pixel " + std::to_string(x) + "," + std::to_string(y) + " is not in the picture", "pixel",
              "give x from " + std::to_string(rect.left) + " to " + std::to_string(rect.right() - 1) +
                  " and y from " + std::to_string(rect.top) + " to " + std::to_string(rect.bottom() - 1));
}

void check_method(const RenderSettings& settings) {
  if (settings.z_interpolation != ZInterpolation::plane &&
      settings.visibility != VisibilityMethod::scanline) {
    throw Error(ErrorKind::usage, "only the scanline method interpolates depth along edges and spans",
                "z-interpolation", "choose scanline for visibility, or plane for the interpolation");
  }
  if (settings.depth_format != DepthFormat::reversed && settings.visibility == VisibilityMethod::raycast) {
    throw Error(ErrorKind::usage, "ray casting compares distances along rays, not depths in a buffer",
                "depth-format", "choose reversed, or another method for visibility");
  }
}

void check_widths(const RenderSettings& settings) {
  check_width(settings.line_width, "line width");
  check_width(settings.point_size, "point size");
}

void check_samples(const RenderSettings& settings) {
  if (is_sample_count(settings.samples)) return;
  throw Error(ErrorKind::usage, "there is no pattern of " + std::to_string(settings.samples) + " samples",
              "samples", "give 1 (none), 4, 8 or 16");
}

void check_machine(const RenderSettings& settings) {
  if (settings.threads < 0 || settings.threads > most_threads) {
    throw Error(
        ErrorKind::usage, std::to_string(settings.threads) + " threads cannot be had", "threads",
        "give a number from 1 to " + std::to_string(most_threads) + ", or 0 for all of the machine's");
  }
  if (is_available(settings.isa)) return;
  std::string available;
  for (const Isa isa : available_isas()) available += std::string(" ") + name_of(isa);
  throw Error(ErrorKind::usage,
              std::string("this machine, or this build of velum, has no ") + name_of(settings.isa), "isa",
              "choose best, or one of:" + available);
}

ViewingTransform requested_view(const Camera& camera, const RenderSettings& settings) {
  const double aspect = static_cast<double>(settings.width) / settings.height;
  return camera.viewing_transform(aspect, 0.5 / settings.width);
}

void check_target(const PictureTarget& target, const Rect& rect) {
  check_view(target.colour, "colour", rect);
  check_view(target.depth, "depth", rect);
  check_view(target.metric_depth, "metric_depth", rect);
  check_view(target.normal, "normal", rect);
  check_view(target.object_id, "object_id", rect);
  check_view(target.triangle_id, "triangle_id", rect);
}

}  // namespace velum
