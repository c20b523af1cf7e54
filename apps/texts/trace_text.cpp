#include "trace_text.hpp"

#include "text.hpp"

namespace velum_app {

using namespace velum;

std::string long_text(double value) {
  return number_text(value, 9);
}

std::string tuple_text(const glm::dvec2& v) {
  return "(" + long_text(v.x) + ", " + long_text(v.y) + ")";
}

std::string tuple_text(const glm::dvec3& v) {
  return "(" + long_text(v.x) + ", " + long_text(v.y) + ", " + long_text(v.z) + ")";
}

std::string tuple_text(const glm::dvec4& v) {
  return "(" + long_text(v.x) + ", " + long_text(v.y) + ", " + long_text(v.z) + ", " + long_text(v.w) + ")";
}

std::string tuple_text(const SnappedVertex& v) {
  return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ")";
}

std::string operand_text(double value) {
  const std::string text = long_text(value);
  return text[0] == '-' ? "(" + text + ")" : text;
}

std::string bits_text(Outcode code) {
  std::string text;
  for (int i = clip_plane_count; i-- > 0;) text += (code >> i & 1) != 0 ? '1' : '0';
  return text;
}

std::string plane_names(Outcode code) {
  std::string text;
  for (int i = 0; i < clip_plane_count; ++i) {
    if ((code >> i & 1) == 0) continue;
    text += (text.empty() ? "" : ", ") + std::string(clip_planes[static_cast<std::size_t>(i)].name);
  }
  return text;
}

std::string outcode_text(Outcode code) {
  return bits_text(code) + (code == 0 ? ": inside" : ": outside " + plane_names(code));
}

const char* kind_name(PrimitiveKind kind) {
  switch (kind) {
    case PrimitiveKind::triangle:
      return "triangle";
    case PrimitiveKind::segment:
      return "segment";
    case PrimitiveKind::point:
      return "point";
  }
  return "";
}

std::string place_text(const Scene& scene, const PrimitivePlace& place) {
  const std::string& name = scene.instances()[place.instance].name;
  return "object " + std::to_string(place.instance) + (name.empty() ? "" : " \"" + name + "\"") + ", its " +
         kind_name(place.kind) + " " + std::to_string(place.index);
}

}  // namespace velum_app
