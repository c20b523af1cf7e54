#include "scene/stl_reader.hpp"

#include <cmath>

#include "reading.hpp"

using velum::Mesh;
using velum::MissingNormals;
using velum::Scene;

namespace {

constexpr std::string_view two_facets =
    "solid roof\n"
    "  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n      vertex 1 0 0\n      vertex 0 1 0\n"
    "    endloop\n  endfacet\n"
    "facet normal nan x 0 outer loop vertex 1 -0.0 0 vertex -0 0 0 vertex 0 0 1 endloop endfacet\n"
    "endsolid roof\n";

void append(std::string& bytes, const void* data, std::size_t size) {
  bytes.append(static_cast<const char*>(data), size);
}

std::string binary(std::string_view header, const std::vector<float>& coordinates) {
  std::string bytes(header);
  bytes.resize(80, '\0');
  const auto count = static_cast<std::uint32_t>(coordinates.size() / 9);
  append(bytes, &count, 4);
  for (std::size_t f = 0; f < count; ++f) {
    const float normal[3] = {1, 2, 3};
    append(bytes, normal, 12);
    append(bytes, coordinates.data() + 9 * f, 36);
    bytes += "\x12\x34";
  }
  return bytes;
}

std::string two_binary_facets(std::string_view header) {
  return binary(header, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, -0.0f, 0, -0.0f, 0, 0, 0, 0, 1});
}

void check_roof(const Scene& scene, const std::string& name) {
  REQUIRE(scene.meshes().size() == 1);
  const Mesh& mesh = scene.meshes()[0];
  CHECK(mesh.name == name);
  CHECK(mesh.positions.size() == 4);
  REQUIRE(mesh.triangles.size() == 2);
  CHECK(mesh.triangles[0] == glm::uvec3(0, 1, 2));
  CHECK(mesh.triangles[1] == glm::uvec3(1, 0, 3));
  CHECK(mesh.positions[3] == glm::vec3(0, 0, 1));
  const float half = static_cast<float>(std::sqrt(0.5));
  CHECK(mesh.normals[0] == glm::vec3(0, half, half));
  CHECK(mesh.normals[2] == glm::vec3(0, 0, 1));
  CHECK(scene.notes.empty());
}

}  // namespace

TEST_CASE("STL: ASCII and binary give the same mesh, by content whatever the name") {
  for (const char* name : {"a.stl", "a.obj", "a"}) {
    check_roof(read(two_facets, name), "roof");
    check_roof(read(two_binary_facets("made by hand"), name), "a");
    check_roof(read(two_binary_facets("solid but binary"), name), "a");
  }
  const Mesh flat = read(two_facets, "a.stl", MissingNormals::flat).meshes()[0];
  CHECK(flat.positions.size() == 6);
  CHECK(flat.normals[3] == glm::vec3(0, 1, 0));
}

TEST_CASE("STL: several solids, empty ones, names, case and line ends") {
  const Scene scene = read(
      "SOLID\r\nENDSOLID\r\nsolid b c\rFacet Normal 0 0 1 Outer Loop\rVertex 0 0 0 vertex +1 0 0 "
      "vertex 0 1e0 0\rEndLoop EndFacet\rEndSolid b c\rsolid d\nendsolid",
      "a.stl");
  REQUIRE(scene.meshes().size() == 1);
  CHECK(scene.meshes()[0].name == "b c");
  CHECK(scene.primitive_count() == 1);
  const Scene empty = read("solid nothing\nendsolid nothing\n", "a.stl");
  CHECK(empty.primitive_count() == 0);
  CHECK(empty.notes.size() == 1);
  CHECK(read(binary("", {}), "a.stl").notes.size() == 1);
}

TEST_CASE("STL: mistakes name the line or the byte") {
  const auto fails = [](std::string_view text, std::string_view part) {
    const std::string message = failure(text, "a.stl");
    CAPTURE(message);
    CHECK(contains(message, part));
  };
  fails("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 z\n",
        "a.stl:4: a coordinate is not a number: \"z\"");
  fails("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 0\nendloop",
        "a.stl:6: \"vertex\" is expected");
  fails("solid x\nfacet normal 0 0 1\nouter", "a.stl:3: the file ends where \"loop\" is expected");
  fails("solid x\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 0 0 0 vertex 0 0 0 endloop endfacet",
        "the file ends before \"endsolid\"");
  const std::string whole = two_binary_facets("made by hand");
  fails(whole.substr(0, whole.size() - 1), "byte 80: 2 facets are announced, but the file ends after 1");
  fails("short", "at least 84 bytes");
  const Scene longer = read(whole + "abc", "a.stl");
  REQUIRE(longer.notes.size() == 1);
  CHECK(contains(longer.notes[0], "3 bytes behind the last facet"));
}

TEST_CASE("STL: no bytes crash, hang or take too much memory") {
  check_prefixes_and_mutations(two_facets, "a.stl", 400, 21);
  check_prefixes_and_mutations(two_binary_facets("made by hand"), "a.stl", 400, 22);
  std::vector<float> coordinates;
  for (int i = 0; i < 9 * 20000; ++i) coordinates.push_back(static_cast<float>(i));
  check_survives(binary("", coordinates), "a.stl");
}

TEST_CASE("[long] STL: many mutations") {
  Random random{23};
  for (int i = 0; i < 10000; ++i) {
    check_survives(mutated(two_facets, random), "a.stl");
    check_survives(mutated(two_binary_facets("x"), random), "a.stl");
  }
}
