#include "obj_statements.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "../base/error.hpp"
#include "file_colours.hpp"
#include "memory_bound.hpp"
#include "text_scanner.hpp"

namespace velum {
namespace {

constexpr std::string_view known_keywords[] = {
    "v",      "vt",       "vn",       "f",      "fo",     "o",      "g",     "s",          "usemtl",
    "mtllib", "l",        "p",        "vp",     "mg",     "deg",    "step",  "curv",       "curv2",
    "surf",   "parm",     "trim",     "hole",   "scrv",   "sp",     "end",   "con",        "bmat",
    "bzp",    "bsp",      "cdc",      "cdp",    "res",    "cstype", "lod",   "shadow_obj", "trace_obj",
    "bevel",  "c_interp", "d_interp", "usemap", "maplib", "ctech",  "stech", "call"};

// So that all sums of two places, and three times a triangle's, fit 32 bits.
constexpr std::int64_t most_elements = std::int64_t{1} << 30;

// What one run costs in Scene (mesh, instance, arrays, the vectors they grow in), names apart.
constexpr std::size_t bytes_per_run = 1600;

// Names view the file: most often it is the very same place, and long names cost nothing per face then.
bool is_same(std::string_view a, std::string_view b) {
  return (a.data() == b.data() && a.size() == b.size()) || a == b;
}

class ObjParser {
 public:
  ObjParser(std::string_view text, const std::string& name)
      : scanner_(text, name, {'#', true}), name_(name), file_bytes_(text.size()) {}

  ObjStatements parse();

 private:
  // The largest index met per list and where, for references to what comes later in the file.
  struct Largest {
    std::uint64_t index = 0;
    std::size_t line = 0;
  };

  void statement(std::string_view keyword);
  void vertex();
  void texture_coordinate();
  void normal();
  void face();
  void line();
  void point();
  void library();
  void begin_run_if_new();
  ObjCorner corner(std::string_view token);
  std::uint32_t index(const char*& first, const char* last, std::size_t count, Largest& largest,
                      std::string_view token);
  void check_size() const;
  void check_references(const Largest& largest, std::size_t count, const char* what) const;
  void write_notes();

  TextScanner scanner_;
  const std::string& name_;
  std::size_t file_bytes_;
  ObjStatements out_;
  std::string_view object_, material_;
  std::size_t run_bytes_ = 0;
  Largest largest_position_, largest_texture_, largest_normal_;
  std::size_t short_lines_ = 0, small_faces_ = 0, unknown_ = 0, known_ = 0;
  std::string first_unknown_;
};

ObjStatements ObjParser::parse() {
  while (!scanner_.at_end()) {
    const std::string_view keyword = scanner_.token();
    if (!keyword.empty()) statement(keyword);
    scanner_.next_line();
  }
  if (known_ == 0 && unknown_ > 0) {
    throw Error(ErrorKind::read, "no line is an OBJ statement", name_, "give a mesh in OBJ, STL or PLY form");
  }
  check_size();
  check_references(largest_position_, out_.positions.size(), "vertices");
  check_references(largest_texture_, out_.texture_coordinates.size(), "texture coordinates");
  check_references(largest_normal_, out_.normals.size(), "normals");
  write_notes();
  return std::move(out_);
}

void ObjParser::statement(std::string_view keyword) {
  ++known_;
  if (keyword == "v") return vertex();
  if (keyword == "f" || keyword == "fo") return face();
  if (keyword == "vt") return texture_coordinate();
  if (keyword == "vn") return normal();
  if (keyword == "l") return line();
  if (keyword == "p") return point();
  if (keyword == "o")
    object_ = scanner_.rest_of_line();
  else if (keyword == "usemtl")
    material_ = scanner_.rest_of_line();
  else if (keyword == "mtllib")
    library();
  else if (keyword != "g" && keyword != "s") {
    if (!is_obj_keyword(keyword)) --known_;
    if (unknown_++ == 0) first_unknown_ = quoted(keyword) + " in line " + std::to_string(scanner_.line());
  }
}

// v x y z [w], or v x y z r g b [a]. The weight w belongs to rational curves and is not used.
void ObjParser::vertex() {
  std::array<float, 7> values{};
  std::size_t count = 0;
  for (std::string_view token = scanner_.token(); !token.empty() && count < values.size();
       token = scanner_.token()) {
    values[count++] = scanner_.number(token, "a coordinate");
  }
  if (count < 3)
    scanner_.fail("a vertex needs three coordinates", "complete the line, or export the file again");
  out_.positions.emplace_back(values[0], values[1], values[2]);
  if (count >= 6 || !out_.colours.empty()) {
    out_.colours.resize(out_.positions.size() - 1, glm::vec4(1.0f));
    glm::vec4 colour(1.0f);
    for (int i = 0; i < 3 && count >= 6; ++i) {
      colour[i] = linear_from_srgb_value(static_cast<double>(values[static_cast<std::size_t>(3 + i)]));
    }
    if (count == 7) colour.a = values[6] > 0.0f ? std::min(values[6], 1.0f) : 0.0f;
    out_.colours.push_back(colour);
  }
}

void ObjParser::texture_coordinate() {
  const float u = scanner_.number(scanner_.token(), "a texture coordinate");
  const std::string_view second = scanner_.token();  // one-dimensional textures have none
  out_.texture_coordinates.emplace_back(
      u, second.empty() ? 0.0f : scanner_.number(second, "a texture coordinate"));
}

void ObjParser::normal() {
  glm::vec3 value;
  for (int i = 0; i < 3; ++i) value[i] = scanner_.number(scanner_.token(), "a component of a normal");
  out_.normals.push_back(value);
}

void ObjParser::face() {
  const std::size_t first = out_.corners.size();
  for (std::string_view token = scanner_.token(); !token.empty(); token = scanner_.token()) {
    out_.corners.push_back(corner(token));
  }
  const std::size_t count = out_.corners.size() - first;
  if (count < 3) {
    ++small_faces_;
    out_.corners.resize(first);
    return;
  }
  begin_run_if_new();
  const std::size_t line = std::min<std::size_t>(scanner_.line(), 0xFFFFFFFFu);
  out_.polygons.push_back({static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(line)});
}

// l v1[/vt1] v2[/vt2] …: a polyline. Texture coordinates are not used.
void ObjParser::line() {
  std::string_view token = scanner_.token();
  if (token.empty()) return void(++short_lines_);
  std::uint32_t from = corner(token).position;
  token = scanner_.token();
  if (token.empty()) return void(++short_lines_);
  begin_run_if_new();
  for (; !token.empty(); token = scanner_.token()) {
    const std::uint32_t to = corner(token).position;
    out_.segments.emplace_back(from, to);
    from = to;
  }
}

// p v1 v2 …
void ObjParser::point() {
  std::string_view token = scanner_.token();
  if (!token.empty()) begin_run_if_new();
  for (; !token.empty(); token = scanner_.token()) out_.points.push_back(corner(token).position);
}

// position, position/texture, position//normal or position/texture/normal
ObjCorner ObjParser::corner(std::string_view token) {
  const char* at = token.data();
  const char* const last = at + token.size();
  ObjCorner result;
  result.position = index(at, last, out_.positions.size(), largest_position_, token);
  if (at != last && *at == '/') {
    ++at;
    if (at != last && *at != '/') {
      result.texture = index(at, last, out_.texture_coordinates.size(), largest_texture_, token);
    }
    if (at != last && *at == '/' && ++at != last) {
      result.normal = index(at, last, out_.normals.size(), largest_normal_, token);
    }
  }
  if (at != last) scanner_.fail("a corner is not of the form v, v/vt, v//vn or v/vt/vn: " + quoted(token));
  return result;
}

// Counted from 1, or backwards from -1, the latest; 0 does not exist.
std::uint32_t ObjParser::index(const char*& first, const char* last, std::size_t count, Largest& largest,
                               std::string_view token) {
  std::int64_t value = 0;
  if (first != last && *first == '+') ++first;
  const auto parsed = std::from_chars(first, last, value);
  if (parsed.ec != std::errc()) scanner_.fail("an index is not a whole number: " + quoted(token));
  first = parsed.ptr;
  const auto available = static_cast<std::int64_t>(count);
  if (value == 0) scanner_.fail("the index 0 in " + quoted(token), "OBJ counts from 1, or back from -1");
  if (value < -available) {
    scanner_.fail("the index " + std::to_string(value) + " reaches back further than the " +
                  std::to_string(available) + " read so far");
  }
  const std::int64_t place = value < 0 ? available + value : value - 1;
  if (place >= most_elements) scanner_.fail("the index " + std::to_string(value) + " is too large");
  if (place >= available && static_cast<std::uint64_t>(value) > largest.index) {
    largest = {static_cast<std::uint64_t>(value), scanner_.line()};
  }
  return static_cast<std::uint32_t>(place);
}

void ObjParser::check_size() const {
  const std::size_t largest =
      std::max({out_.positions.size(), out_.texture_coordinates.size(), out_.normals.size(),
                out_.corners.size(), out_.polygons.size(), out_.segments.size(), out_.points.size()});
  if (largest <= static_cast<std::size_t>(most_elements)) return;
  throw Error(ErrorKind::read, "more than 1,073,741,824 elements of one kind", name_, "split the file");
}

void ObjParser::check_references(const Largest& largest, std::size_t count, const char* what) const {
  if (largest.index <= count) return;
  throw Error(
      ErrorKind::read,
      "index " + std::to_string(largest.index) + ", but the file has " + std::to_string(count) + " " + what,
      name_ + ":" + std::to_string(largest.line), "check that the file is whole, or export it again");
}

void ObjParser::begin_run_if_new() {
  if (!out_.runs.empty() && is_same(out_.runs.back().object, object_) &&
      is_same(out_.runs.back().material, material_)) {
    return;
  }
  run_bytes_ += bytes_per_run + 2 * object_.size() + material_.size();
  require_within_memory_bound(run_bytes_, file_bytes_, "so many objects and materials", scanner_.where());
  out_.runs.push_back({object_, material_, out_.polygons.size(), out_.segments.size(), out_.points.size()});
}

void ObjParser::library() {
  const std::string_view names = scanner_.rest_of_line();
  if (!names.empty()) out_.libraries.push_back(names);
}

void ObjParser::write_notes() {
  const auto note = [&](std::size_t count, const char* text) {
    if (count > 0) out_.notes.push_back(std::to_string(count) + text);
  };
  note(short_lines_, " line elements (l) with fewer than two vertices are left out");
  note(small_faces_, " faces with fewer than three corners are left out");
  if (unknown_ > 0)
    note(unknown_, (" statements of other kinds are left out, the first is " + first_unknown_).c_str());
}

}  // namespace

ObjStatements read_obj_statements(std::string_view text, const std::string& name) {
  return ObjParser(text, name).parse();
}

bool is_obj_keyword(std::string_view word) {
  return std::find(std::begin(known_keywords), std::end(known_keywords), word) != std::end(known_keywords);
}

}  // namespace velum
