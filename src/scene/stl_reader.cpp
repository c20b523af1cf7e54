#include "stl_reader.hpp"

#include <bit>

#include "../base/error.hpp"
#include "byte_order.hpp"
#include "key_table.hpp"
#include "missing_normals.hpp"
#include "text_scanner.hpp"

namespace velum {
namespace {

constexpr std::size_t header_size = 84, facet_size = 50;

std::uint32_t facet_count(std::span<const std::byte> bytes) {
  return load_integer<std::uint32_t>(bytes.data() + 80, std::endian::little);
}

// The vertices and triangles of one solid, as its facets come in.
class Solid {
 public:
  explicit Solid(std::string name) : name_(std::move(name)) {}

  bool is_empty() const { return triangles_.empty(); }
  void reserve(std::size_t facets) { triangles_.reserve(facets); }

  void add_facet(const glm::vec3 (&corners)[3]) {
    glm::uvec3 triangle;
    for (int i = 0; i < 3; ++i) {
      const glm::vec3 p = corners[i] + 0.0f;  // -0 becomes 0
      triangle[i] = vertices_.number_of({std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
                                         std::bit_cast<std::uint32_t>(p.z)});
    }
    triangles_.push_back(triangle);
  }

  Mesh take_mesh() {
    std::vector<glm::vec3> positions;
    positions.reserve(vertices_.keys().size());
    for (const glm::uvec3& key : vertices_.keys()) {
      positions.emplace_back(std::bit_cast<float>(key.x), std::bit_cast<float>(key.y),
                             std::bit_cast<float>(key.z));
    }
    Mesh mesh;
    mesh.name = std::move(name_);
    mesh.positions = std::move(positions);
    mesh.triangles = std::move(triangles_);
    return mesh;
  }

 private:
  std::string name_;
  KeyTable vertices_;
  std::vector<glm::uvec3> triangles_;
};

void add_to_scene(Scene& scene, Solid& solid, const LoadOptions& options, std::size_t file_bytes,
                  const std::string& where) {
  if (solid.is_empty()) return;
  const Mesh mesh = solid.take_mesh();
  note_positions_not_finite(mesh.positions.span(), scene.notes);
  scene.add(with_complete_normals(mesh, options.missing_normals, file_bytes, where));
}

class AsciiParser {
 public:
  AsciiParser(std::string_view text, const std::string& name)
      : scanner_(text, name), name_(name), size_(text.size()) {}

  Scene parse(const LoadOptions& options);

 private:
  void expect(std::string_view expected);
  void facet(Solid& solid);

  TextScanner scanner_;
  const std::string& name_;
  std::size_t size_;
};

Scene AsciiParser::parse(const LoadOptions& options) {
  Scene scene;
  const std::string stem = std::filesystem::path(name_).stem().string();
  for (std::string_view word = scanner_.word(); !word.empty(); word = scanner_.word()) {
    if (!equal_ignoring_case(word, "solid")) scanner_.fail("\"solid\" is expected, not " + quoted(word));
    const std::string_view solid_name = scanner_.rest_of_line();
    Solid solid(solid_name.empty() ? stem : std::string(solid_name));
    while (true) {
      const std::string_view inner = scanner_.word();
      if (equal_ignoring_case(inner, "endsolid")) break;
      if (inner.empty()) scanner_.fail("the file ends before \"endsolid\"", "export it again");
      if (!equal_ignoring_case(inner, "facet")) scanner_.fail("\"facet\" is expected, not " + quoted(inner));
      facet(solid);
    }
    scanner_.next_line();  // the name again
    add_to_scene(scene, solid, options, size_, name_);
  }
  return scene;
}

void AsciiParser::expect(std::string_view expected) {
  const std::string_view word = scanner_.word();
  if (equal_ignoring_case(word, expected)) return;
  if (word.empty())
    scanner_.fail("the file ends where \"" + std::string(expected) + "\" is expected", "export it again");
  scanner_.fail("\"" + std::string(expected) + "\" is expected, not " + quoted(word),
                "facets are triangles: facet normal, outer loop, three vertices, endloop, endfacet");
}

void AsciiParser::facet(Solid& solid) {
  expect("normal");
  for (int i = 0; i < 3; ++i) scanner_.word();  // not used, so it may be anything
  expect("outer");
  expect("loop");
  glm::vec3 corners[3];
  for (glm::vec3& corner : corners) {
    expect("vertex");
    for (int i = 0; i < 3; ++i) corner[i] = scanner_.number(scanner_.word(), "a coordinate");
  }
  expect("endloop");
  expect("endfacet");
  solid.add_facet(corners);
}

}  // namespace

bool is_exact_binary_stl(std::span<const std::byte> bytes) {
  return bytes.size() >= header_size &&
         bytes.size() == header_size + std::uint64_t{facet_size} * facet_count(bytes);
}

Scene read_ascii_stl(std::string_view text, const std::string& name, const LoadOptions& options) {
  Scene scene = AsciiParser(text, name).parse(options);
  if (scene.meshes().empty()) scene.notes.push_back("the file has no facets, there is nothing to draw");
  return scene;
}

Scene read_binary_stl(std::span<const std::byte> bytes, const std::string& name, const LoadOptions& options) {
  if (bytes.size() < header_size) {
    throw Error(ErrorKind::read,
                "a binary STL file has at least 84 bytes, this has " + std::to_string(bytes.size()), name,
                "check that the file is whole, or export it again");
  }
  const std::size_t count = facet_count(bytes), held = (bytes.size() - header_size) / facet_size;
  if (count > held) {
    throw Error(
        ErrorKind::read,
        std::to_string(count) + " facets are announced, but the file ends after " + std::to_string(held),
        name + ": byte 80", "check that the file is whole, or export it again");
  }
  Solid solid(std::filesystem::path(name).stem().string());
  solid.reserve(count);
  for (std::size_t f = 0; f < count; ++f) {
    const std::byte* at =
        bytes.data() + header_size + f * facet_size + 3 * sizeof(float);  // behind the normal
    glm::vec3 corners[3];
    for (glm::vec3& corner : corners) {
      for (int i = 0; i < 3; ++i, at += sizeof(float)) corner[i] = load_float(at, std::endian::little);
    }
    solid.add_facet(corners);
  }
  Scene scene;
  if (count == 0) scene.notes.push_back("the file has no facets, there is nothing to draw");
  if (bytes.size() != header_size + count * facet_size) {
    scene.notes.push_back(std::to_string(bytes.size() - header_size - count * facet_size) +
                          " bytes behind the last facet are left out");
  }
  add_to_scene(scene, solid, options, bytes.size(), name);
  return scene;
}

}  // namespace velum
