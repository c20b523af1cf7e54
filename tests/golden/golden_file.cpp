#include "golden_file.hpp"

#include <algorithm>
#include <span>

namespace golden {
namespace {

using namespace velum;
namespace fs = std::filesystem;

std::string size_text(const Image<Rgba8>& image) {
  return std::to_string(image.width()) + "x" + std::to_string(image.height());
}

fs::path save(const std::string& name, const std::string& what, const Image<Rgba8>& image,
              const Places& places) {
  fs::create_directories(places.failures);
  const fs::path path = places.failures / file_name(name).replace_extension(what + ".png");
  write_png(path, image);
  return path;
}

std::string difference_text(const ImageDifference& difference) {
  return std::to_string(difference.pixels_over) +
         (difference.pixels_over == 1 ? " pixel differs" : " pixels differ") + ", the worst at (" +
         std::to_string(difference.worst_x) + ", " + std::to_string(difference.worst_y) + ") by " +
         std::to_string(static_cast<int>(difference.max));
}

}  // namespace

fs::path file_name(const std::string& name) {
  std::string text = name + ".png";
  std::replace(text.begin(), text.end(), '/', '.');
  return text;
}

std::optional<std::string> failure_of(const std::string& name, const Image<Rgba8>& actual,
                                      const Image<Rgba8>& expected, const std::string& expected_name,
                                      const Places& places) {
  const bool same_size = actual.width() == expected.width() && actual.height() == expected.height();
  if (same_size && compare(expected, actual).same_bytes) return {};
  std::string text = name + " is not " + expected_name + ": ";
  text += same_size ? difference_text(compare(expected, actual))
                    : "its size is " + size_text(actual) + " instead of " + size_text(expected);
  text += "\n  actual:   " + save(name, "actual", actual, places).string();
  text += "\n  expected: " + save(name, "expected", expected, places).string();
  if (same_size) text += "\n  heat map: " + save(name, "heat", heat_map(expected, actual), places).string();
  return text;
}

std::optional<std::string> failure_of(const std::string& name, const Image<Rgba8>& actual,
                                      const Places& places) {
  const fs::path path = places.pictures / file_name(name);
  if (!fs::exists(path)) {
    return name + ": there is no golden " + path.string() +
           "; look at the picture, then ./run goldens\n  actual:   " +
           save(name, "actual", actual, places).string();
  }
  return failure_of(name, actual, read_png(path), "the golden " + path.string(), places);
}

bool refresh(const std::string& name, const Image<Rgba8>& actual, const Places& places) {
  const fs::path path = places.pictures / file_name(name);
  if (fs::exists(path)) {
    const Image<Rgba8> present = read_png(path);
    const bool same_size = present.width() == actual.width() && present.height() == actual.height();
    if (same_size && compare(present, actual).same_bytes) return false;
  }
  fs::create_directories(places.pictures);
  write_png(path, actual);
  return true;
}

bool refresh_text(const fs::path& path, const std::string& text) {
  if (fs::exists(path)) {
    const std::vector<std::byte> present = read_file(path);
    if (std::ranges::equal(present, std::as_bytes(std::span(text)))) return false;
  }
  write_file(path, std::as_bytes(std::span(text)));
  return true;
}

}  // namespace golden
