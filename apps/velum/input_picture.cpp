#include "input_picture.hpp"

#include <string_view>

namespace velum_app {

using namespace velum;

InputPicture read_picture(const std::string& path) {
  const std::vector<std::byte> bytes = read_file(path);
  const std::string name = input_name(path);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("\x89PNG")) return decode_png(bytes, name);
  if (text.starts_with("P6")) return decode_ppm(bytes, name);
  if (text.starts_with("Pf")) return decode_pfm(bytes, name);
  if (text.starts_with("PF")) return decode_pfm_rgb(bytes, name);
  throw Error(ErrorKind::read, "this is no PNG, PPM (P6) or PFM", name, "convert it to one of them");
}

const char* content_of(const InputPicture& picture) {
  constexpr const char* contents[] = {"8-bit colours", "one float a pixel", "three floats a pixel"};
  return contents[picture.index()];
}

}  // namespace velum_app
