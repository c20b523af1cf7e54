#include "file_format.hpp"

#include <filesystem>
#include <optional>
#include <string_view>

#include "../base/error.hpp"
#include "obj_statements.hpp"
#include "ply_header.hpp"
#include "stl_reader.hpp"
#include "text_scanner.hpp"

namespace velum {
namespace {

constexpr const char* known = "OBJ, STL and PLY are read; export the mesh as one of them";

// Other programs' formats, and encodings, that one line can recognise: so the message can name them.
std::optional<std::string_view> foreign_content(std::string_view text) {
  constexpr std::pair<std::string_view, std::string_view> signs[] = {{"glTF", "a glTF binary"},
                                                                     {"OFF", "an OFF file"},
                                                                     {"COFF", "an OFF file"},
                                                                     {"PK\x03\x04", "a ZIP archive"},
                                                                     {"Kaydara FBX", "an FBX file"},
                                                                     {"BLENDER", "a Blender file"},
                                                                     {"\x1F\x8B", "a gzip archive"},
                                                                     {"\xFF\xFE", "text in UTF-16"},
                                                                     {"\xFE\xFF", "text in UTF-16"},
                                                                     {"<?xml", "an XML file"},
                                                                     {"{", "a JSON file"}};
  for (const auto& [sign, what] : signs) {
    if (text.substr(0, sign.size()) == sign) return what;
  }
  return std::nullopt;
}

// A binary STL file may begin with "solid" too, but not go on with a facet or its end.
bool looks_like_ascii_stl(std::string_view text) {
  TextScanner scanner(text.substr(0, 4096), {});
  if (!equal_ignoring_case(scanner.word(), "solid")) return false;
  scanner.next_line();
  const std::string_view next = scanner.word();
  return next.empty() || equal_ignoring_case(next, "facet") || equal_ignoring_case(next, "endsolid");
}

// Some of the first lines with a statement is OBJ's.
bool looks_like_obj(std::string_view text) {
  constexpr std::size_t looked_at = 65536;
  TextScanner scanner(text.substr(0, looked_at), {}, {'#', true});
  for (int statements = 0; statements < 8 && !scanner.at_end(); scanner.next_line()) {
    const std::string_view word = scanner.token();
    if (is_obj_keyword(word)) return true;
    if (!word.empty()) ++statements;
  }
  return false;
}

}  // namespace

FileFormat format_of(std::span<const std::byte> bytes, const std::string& name) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::string extension = std::filesystem::path(name).extension().string();
  if (text.empty()) throw Error(ErrorKind::read, "the file is empty", name, "export it again");
  if (has_ply_magic(text)) return FileFormat::ply;
  if (is_exact_binary_stl(bytes)) return FileFormat::binary_stl;
  if (looks_like_ascii_stl(text)) return FileFormat::ascii_stl;
  if (const auto foreign = foreign_content(text)) {
    throw Error(ErrorKind::read, "this is " + std::string(*foreign), name, known);
  }
  if (equal_ignoring_case(extension, ".stl")) return FileFormat::binary_stl;
  if (equal_ignoring_case(extension, ".ply")) return FileFormat::ply;
  if (equal_ignoring_case(extension, ".obj") || looks_like_obj(text)) return FileFormat::obj;
  throw Error(ErrorKind::read, "neither content nor name tell what kind of mesh this is", name, known);
}

}  // namespace velum
