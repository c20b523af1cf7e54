#include "ply_header.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "text_scanner.hpp"

namespace velum {
namespace {

std::optional<PlyType> type_named(std::string_view name) {
  constexpr std::pair<std::string_view, PlyType> names[] = {
      {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
      {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
      {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
      {"float64", PlyType::float64}};
  for (const auto& [known, type] : names) {
    if (known == name) return type;
  }
  return std::nullopt;
}

PlyRole scalar_role(std::string_view name) {
  constexpr std::pair<std::string_view, PlyRole> names[] = {{"x", PlyRole::x},
                                                            {"y", PlyRole::y},
                                                            {"z", PlyRole::z},
                                                            {"nx", PlyRole::nx},
                                                            {"ny", PlyRole::ny},
                                                            {"nz", PlyRole::nz},
                                                            {"red", PlyRole::red},
                                                            {"green", PlyRole::green},
                                                            {"blue", PlyRole::blue},
                                                            {"alpha", PlyRole::alpha},
                                                            {"r", PlyRole::red},
                                                            {"g", PlyRole::green},
                                                            {"b", PlyRole::blue},
                                                            {"a", PlyRole::alpha},
                                                            {"diffuse_red", PlyRole::red},
                                                            {"diffuse_green", PlyRole::green},
                                                            {"diffuse_blue", PlyRole::blue},
                                                            {"diffuse_alpha", PlyRole::alpha},
                                                            {"s", PlyRole::u},
                                                            {"t", PlyRole::v},
                                                            {"u", PlyRole::u},
                                                            {"v", PlyRole::v},
                                                            {"texture_u", PlyRole::u},
                                                            {"texture_v", PlyRole::v},
                                                            {"texture_s", PlyRole::u},
                                                            {"texture_t", PlyRole::v}};
  for (const auto& [known, role] : names) {
    if (known == name) return role;
  }
  return PlyRole::none;
}

PlyRole role_of(const PlyElement& element, std::string_view name, bool is_list) {
  const bool has_corners = element.name == "face" || element.name == "tristrips";
  const bool is_corners = name == "vertex_indices" || name == "vertex_index";
  if (is_list) return has_corners && is_corners ? PlyRole::corners : PlyRole::none;
  if (element.name == "edge") {
    if (name == "vertex1") return PlyRole::vertex1;
    return name == "vertex2" ? PlyRole::vertex2 : PlyRole::none;
  }
  return element.name == "vertex" ? scalar_role(name) : PlyRole::none;
}

class HeaderParser {
 public:
  HeaderParser(std::string_view text, const std::string& name) : text_(text), scanner_(text, name) {}

  PlyHeader parse();

 private:
  void format();
  void element();
  void property();
  PlyType type();

  std::string_view text_;
  TextScanner scanner_;
  PlyHeader header_;
  bool has_format_ = false;
};

PlyHeader HeaderParser::parse() {
  if (scanner_.token() != "ply") scanner_.fail("a PLY file begins with \"ply\"");
  // The data begin right behind the line end, which is as long as that of the first line.
  const std::size_t first_line_end = scanner_.position();
  scanner_.next_line();
  const bool ends_in_two = text_.substr(first_line_end).substr(0, 2) == "\r\n";
  while (true) {
    if (scanner_.at_end()) scanner_.fail("the file ends before \"end_header\"", "export it again");
    const std::string_view keyword = scanner_.token();
    if (keyword == "end_header") break;
    if (keyword == "format")
      format();
    else if (keyword == "element")
      element();
    else if (keyword == "property")
      property();
    else if (keyword != "comment" && keyword != "obj_info" && !header_.elements.empty() && !keyword.empty()) {
      // Before the first element it is a comment without its keyword, as old versions of Blender wrote it.
      scanner_.fail("not a statement of a PLY header: " + quoted(keyword));
    }
    scanner_.next_line();
  }
  if (!has_format_) scanner_.fail("the header has no \"format\" line");
  scanner_.rest_of_line();
  header_.size = std::min(text_.size(), scanner_.position() + (ends_in_two ? 2 : 1));
  header_.line_count = scanner_.line();
  return std::move(header_);
}

void HeaderParser::format() {
  const std::string_view name = scanner_.token();
  if (name == "ascii")
    header_.encoding = PlyEncoding::ascii;
  else if (name == "binary_little_endian")
    header_.encoding = PlyEncoding::little_endian;
  else if (name == "binary_big_endian")
    header_.encoding = PlyEncoding::big_endian;
  else
    scanner_.fail("not a PLY format: " + quoted(name),
                  "ascii, binary_little_endian and binary_big_endian are known");
  has_format_ = true;
}

void HeaderParser::element() {
  PlyElement element;
  element.name = scanner_.token();
  const std::int64_t count = scanner_.integer(scanner_.token(), "the number of elements");
  if (count < 0) scanner_.fail("the number of elements is negative");
  element.count = static_cast<std::uint64_t>(count);
  header_.elements.push_back(std::move(element));
}

PlyType HeaderParser::type() {
  const std::string_view name = scanner_.token();
  if (const std::optional<PlyType> type = type_named(name)) return *type;
  scanner_.fail("not a PLY type: " + quoted(name),
                "char, uchar, short, ushort, int, uint, float, double are known");
}

void HeaderParser::property() {
  if (header_.elements.empty()) scanner_.fail("a property before the first element");
  PlyProperty property;
  TextScanner ahead = scanner_;
  property.is_list = ahead.token() == "list";
  if (property.is_list) {
    scanner_ = ahead;
    property.count_type = type();
    if (is_real(property.count_type)) scanner_.fail("the length of a list is not of a whole type");
  }
  property.type = type();
  property.role = role_of(header_.elements.back(), scanner_.token(), property.is_list);
  if (property.role >= PlyRole::corners && is_real(property.type)) {
    scanner_.fail("vertex indices are not of a whole type");
  }
  header_.elements.back().properties.push_back(property);
}

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

bool is_real(PlyType type) {
  return type == PlyType::float32 || type == PlyType::float64;
}

bool has_ply_magic(std::string_view text) {
  return text.size() > 3 && text.substr(0, 3) == "ply" &&
         (text[3] == '\n' || text[3] == '\r' || text[3] == ' ' || text[3] == '\t');
}

PlyHeader read_ply_header(std::string_view text, const std::string& name) {
  return HeaderParser(text, name).parse();
}

}  // namespace velum
