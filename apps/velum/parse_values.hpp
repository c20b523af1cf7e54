#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <velum/velum.hpp>

namespace velum_app {

/// Values of options, read the same way in every locale. Each throws velum::Error (usage) that names the
/// option, the text and the form expected.

/// A finite number, e.g. "-1.5e3".
double number_from(std::string_view text, const std::string& option);
/// "x,y,z"
glm::dvec3 vector_from(std::string_view text, const std::string& option);
/// Degrees strictly between 0 and 180 → radians.
double opening_angle_from(std::string_view text, const std::string& option);

struct Size {
  int width;
  int height;
};
/// "WxH", each 1 … 32768
Size size_from(std::string_view text, const std::string& option);
struct Pixel {
  int x;
  int y;
};
/// "X,Y" in whole pixels
Pixel pixel_from(std::string_view text, const std::string& option);
/// A whole number ≥ 0
std::uint64_t whole_number_from(std::string_view text, const std::string& option);
/// "X,Y,W,H" in pixels
velum::Rect rect_from(std::string_view text, const std::string& option);
/// "transparent" or "#rrggbb"
velum::Rgba8 colour_from(std::string_view text, const std::string& option);

}  // namespace velum_app
