#include <algorithm>
#include <bit>
#include <cmath>

#include "image/colour.hpp"
#include "reading.hpp"

using velum::Mesh;
using velum::MissingNormals;
using velum::Scene;

namespace {

constexpr std::string_view ascii_square =
    "ply\nformat ascii 1.0\ncomment made by hand\nobj_info nothing\nelement vertex 4\nproperty float x\n"
    "property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

// Appends a value in the given byte order.
template <typename T>
void put(std::string& bytes, T value, std::endian order) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (order != std::endian::native) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::string format(std::endian order) {
  return order == std::endian::little ? "ply\nformat binary_little_endian 1.0\n"
                                      : "ply\nformat binary_big_endian 1.0\n";
}

// Every scalar type, lists where they are not wanted, elements nobody knows.
std::string rich(std::endian order) {
  std::string bytes =
      format(order) +
      "element noise 2\nproperty list ushort double junk\nproperty short more\n"
      "element face 2\nproperty uchar flag\nproperty list uint ushort vertex_index\nproperty float area\n"
      "element vertex 4\nproperty double x\nproperty list char char skipped\nproperty short y\n"
      "property int z\nproperty ushort red\nproperty uchar green\nproperty uint blue\n"
      "property float alpha\nproperty float t\nproperty char s\nelement last 1\nproperty float64 q\n"
      "end_header\n";
  for (int i = 0; i < 2; ++i) {
    put<std::uint16_t>(bytes, 2, order);
    put<double>(bytes, 1.5, order);
    put<double>(bytes, 2.5, order);
    put<std::int16_t>(bytes, -3, order);
  }
  for (std::uint16_t i = 1; i < 3; ++i) {
    put<std::uint8_t>(bytes, 9, order);
    put<std::uint32_t>(bytes, 3, order);
    for (const std::uint16_t corner : {std::uint16_t{0}, i, static_cast<std::uint16_t>(i + 1)})
      put(bytes, corner, order);
    put<float>(bytes, 0.5f, order);
  }
  for (int i = 0; i < 4; ++i) {
    put<double>(bytes, i == 1 || i == 2 ? 0.1 : 0.0, order);
    put<std::int8_t>(bytes, 2, order);
    bytes += "ab";
    put<std::int16_t>(bytes, i >= 2 ? -300 : 0, order);
    put<std::int32_t>(bytes, -70000, order);
    put<std::uint16_t>(bytes, 65535, order);
    put<std::uint8_t>(bytes, 128, order);
    put<std::uint32_t>(bytes, 0, order);
    put<float>(bytes, 0.25f, order);
    put<float>(bytes, 0.5f, order);
    put<std::int8_t>(bytes, -2, order);
  }
  put<double>(bytes, 1.0, order);
  return bytes;
}

std::string binary_square(std::endian order) {
  std::string bytes =
      format(order) +
      "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  for (const float c : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f}) put(bytes, c, order);
  put<std::uint8_t>(bytes, 4, order);
  for (int i = 0; i < 4; ++i) put<std::int32_t>(bytes, i, order);
  return bytes;
}

std::string ascii(std::string_view properties, std::string_view vertices) {
  return "ply\nformat ascii 1.0\nelement vertex 3\n" + std::string(properties) +
         "element face 1\nproperty list uchar int vertex_indices\nend_header\n" + std::string(vertices) +
         "3 0 1 2\n";
}

constexpr const char* xyz = "property float x\nproperty float y\nproperty float z\n";

}  // namespace

TEST_CASE("PLY: the three encodings give the same mesh, by content whatever the name") {
  for (const std::string& text :
       {std::string(ascii_square), binary_square(std::endian::little), binary_square(std::endian::big)}) {
    for (const char* name : {"a.ply", "a.obj"}) {
      const Scene scene = read(text, name);
      REQUIRE(scene.meshes().size() == 1);
      const Mesh& mesh = scene.meshes()[0];
      CHECK(mesh.name == "a");
      REQUIRE(mesh.positions.size() == 4);
      CHECK(mesh.positions[2] == glm::vec3(1, 1, 0));
      REQUIRE(mesh.triangles.size() == 2);
      CHECK(mesh.triangles[0] == glm::uvec3(0, 1, 2));
      CHECK(mesh.triangles[1] == glm::uvec3(0, 2, 3));
      CHECK(mesh.normals[3] == glm::vec3(0, 0, 1));
      CHECK(scene.notes.empty());
    }
    CHECK(read(text, "a.ply", MissingNormals::flat).meshes()[0].positions.size() == 6);
  }
}

TEST_CASE("PLY: any layout, all types, unknown elements, faces before vertices") {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const Scene scene = read(rich(order), "a.ply");
    const Mesh& mesh = scene.meshes().at(0);
    CHECK(mesh.positions[2] == glm::vec3(0.1f, -300.0f, -70000.0f));
    CHECK(mesh.triangles[1] == glm::uvec3(0, 2, 3));
    CHECK(mesh.texture_coordinates[0] == glm::vec2(-2.0f, 0.5f));
    CHECK(mesh.colours[0] == glm::vec4(1.0f, velum::linear_from_srgb(std::uint8_t{128}), 0.0f, 0.25f));
    REQUIRE(scene.notes.size() == 2);
    CHECK(contains(scene.notes[0], "2 elements \"noise\""));
    CHECK(contains(scene.notes[1], "1 elements \"last\""));
  }
}

TEST_CASE("PLY: normals, texture coordinates and colours under their usual names") {
  const Mesh mesh =
      read(ascii(std::string(xyz) +
                     "property float nx\nproperty float ny\nproperty float nz\nproperty float "
                     "u\nproperty float v\nproperty float red\nproperty float green\nproperty float blue\n",
                 "0 0 0 0 3 4 .5 .25 .5 0 1\n1 0 0 0 0 0 0 0 0 0 0\n0 1 0 0 0 -1 0 0 0 0 0\n"),
           "a.ply")
          .meshes()[0];
  CHECK(mesh.normals[0] == glm::vec3(0, 0.6f, 0.8f));
  CHECK(mesh.normals[1] == glm::vec3(0, 0, 1));
  CHECK(mesh.normals[2] == glm::vec3(0, 0, -1));
  CHECK(mesh.texture_coordinates[0] == glm::vec2(0.5f, 0.25f));
  CHECK(mesh.colours[0] == glm::vec4(0.5f, 0, 1, 1));
  const Mesh other =
      read(ascii(std::string(xyz) + "property float texture_u\nproperty float texture_v\nproperty uchar "
                                    "diffuse_red\nproperty uchar diffuse_green\nproperty uchar "
                                    "diffuse_blue\nproperty uchar alpha\n",
                 "0 0 0 1 2 255 128 0 51\n1 0 0 0 0 0 0 0 0\n0 1 0 0 0 300 -1 0 255\n"),
           "a.ply")
          .meshes()[0];
  CHECK(other.texture_coordinates[0] == glm::vec2(1, 2));
  CHECK(other.colours[0] == glm::vec4(1.0f, velum::linear_from_srgb(std::uint8_t{128}), 0.0f, 0.2f));
  CHECK(other.colours[2] == glm::vec4(1, 0, 0, 1));
}

TEST_CASE("PLY: colours are shown as they are, on white; without them the surface is grey") {
  const std::string coloured = "ply\nformat ascii 1.0\nelement vertex 1\n" + std::string(xyz) +
                               "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                               "end_header\n0 0 0 255 128 0\n";
  CHECK(read(coloured, "a.ply").materials()[0].base_colour == glm::vec3(1.0f));
  const std::string plain =
      "ply\nformat ascii 1.0\nelement vertex 1\n" + std::string(xyz) + "end_header\n0 0 0\n";
  CHECK(read(plain, "a.ply").materials()[0].base_colour == velum::Material{}.base_colour);
}

TEST_CASE("PLY: text is rounded once, also for doubles; whole numbers may be written 3.0") {
  const Mesh mesh =
      read(
          "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty double x\r\nproperty double y\r\nproperty "
          "double z\r\nelement face 1\r\nproperty list uchar int vertex_indices\r\nend_header\r\n"
          "1.00000005960464477539062500000001 0 0 1 0\r\n0 0 1 0 3.0 0 1.0 2",
          "a.ply")
          .meshes()[0];
  CHECK(mesh.positions[0].x == std::nextafter(1.0f, 2.0f));
  CHECK(mesh.triangles[0] == glm::uvec3(0, 1, 2));
}

TEST_CASE("PLY: doubles beyond float become infinite or the largest, and are told") {
  std::string bytes =
      format(std::endian::little) +
      "element vertex 1\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
  put(bytes, 1e39, std::endian::little);
  put(bytes, 3.40282350e38, std::endian::little);
  put(bytes, -1e300, std::endian::little);
  const Scene scene = read(bytes, "a.ply");
  const glm::vec3 p = scene.meshes().at(0).positions[0];
  CHECK(std::isinf(p.x));
  CHECK(p.y == std::numeric_limits<float>::max());
  CHECK(std::isinf(p.z));
  CHECK(contains(scene.notes.at(0), "1 vertex positions are not finite"));
}

TEST_CASE("PLY: strips turn every second triangle, -1 begins anew") {
  const Mesh mesh = read("ply\nformat ascii 1.0\nelement vertex 4\n" + std::string(xyz) +
                             "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                             "0 0 0 1 0 0 0 1 0 1 1 0\n8 0 1 2 3 -1 0 1 3\n",
                         "a.ply")
                        .meshes()[0];
  REQUIRE(mesh.triangles.size() == 3);
  CHECK(mesh.triangles[0] == glm::uvec3(0, 1, 2));
  CHECK(mesh.triangles[1] == glm::uvec3(2, 1, 3));
  CHECK(mesh.triangles[2] == glm::uvec3(0, 1, 3));
  CHECK(mesh.normals[3] == glm::vec3(0, 0, 1));
}

TEST_CASE("PLY: edges become segments, beside faces in a mesh of their own") {
  const std::string vertices = "ply\nformat ascii 1.0\nelement vertex 3\n" + std::string(xyz);
  const std::string edges = "element edge 2\nproperty int vertex1\nproperty uchar w\nproperty int vertex2\n";
  const Scene alone = read(vertices + edges + "end_header\n0 0 0 1 0 0 0 1 0\n0 9 1\n2 9 1\n", "a.ply");
  CHECK(alone.notes.empty());
  REQUIRE(alone.primitive_count() == 2);
  CHECK(alone.meshes()[0].segments[1] == glm::uvec2(2, 1));
  CHECK(alone.meshes()[0].normals.empty());
  const Scene both = read(vertices + "element face 1\nproperty list uchar int vertex_indices\n" + edges +
                              "end_header\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n0 9 1\n2 9 1\n",
                          "a.ply");
  REQUIRE(both.meshes().size() == 2);
  CHECK(both.meshes()[0].primitive_count() == 1);
  CHECK(both.meshes()[1].segments.size() == 2);
  CHECK(both.meshes()[1].normals.empty());
  CHECK(contains(failure(vertices + edges + "end_header\n0 0 0 1 0 0 0 1 0\n0 9 3\n0 9 1\n", "a.ply"),
                 "vertex index 3, but there are 3 vertices"));
}

TEST_CASE("PLY: points alone are kept, small faces are left out") {
  const Scene cloud = read(
      "ply\nformat ascii 1.0\nelement vertex 2\n" + std::string(xyz) + "end_header\n0 0 0 1 1 1\n", "a.ply");
  CHECK(cloud.meshes().at(0).positions.size() == 2);
  CHECK(cloud.primitive_count() == 2);
  CHECK(cloud.meshes()[0].points[1] == 1);
  CHECK(cloud.notes.empty());
  const Scene small =
      read("ply\nformat ascii 1.0\nelement vertex 3\n" + std::string(xyz) +
               "element face 3\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1 0 0 0 1 0\n"
               "2 0 1\n3 0 1 2\n0",
           "a.ply");
  CHECK(small.primitive_count() == 1);
  CHECK(contains(small.notes.at(0), "2 faces with fewer than three corners"));
  CHECK(read("ply\nformat ascii 1.0\nelement vertex 0\n" + std::string(xyz) + "end_header\n", "a.ply")
            .meshes()
            .empty());
}

TEST_CASE("PLY: mistakes name the line or the byte") {
  const auto fails = [](std::string_view text, std::string_view part) {
    CAPTURE(text);
    const std::string message = failure(text, "a.ply");
    CAPTURE(message);
    CHECK(contains(message, part));
  };
  fails("nothing", "a.ply:1: a PLY file begins with \"ply\"");
  fails("ply\nformat binary 1.0\n", "a.ply:2: not a PLY format: \"binary\"");
  fails("ply\nelement vertex x\n", "a.ply:2: the number of elements is not a whole number");
  fails("ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n", "a.ply:4: not a PLY type: \"quad\"");
  fails("ply\nproperty float x\n", "a.ply:2: a property before the first element");
  fails("ply\nformat ascii 1.0\n", "the file ends before \"end_header\"");
  fails("ply\nformat ascii 1.0\nelement vertex 1\nproparty float x\n",
        "a.ply:4: not a statement of a PLY header");
  fails("ply\nend_header\n", "no \"format\" line");
  fails(ascii("property float x\nproperty float y\n", "0 0 0 0 0 0"), "the vertices lack x, y or z");
  fails(ascii(xyz, "0 0 0\n0 q 0\n0 0 0\n"), "a.ply:11: not a number: \"q\"");
  fails("ply\nformat ascii 1.0\nelement vertex 99999999999\n" + std::string(xyz) + "end_header\n1 2 3\n",
        "99999999999 elements \"vertex\" are announced");
  fails(
      "ply\nformat ascii 1.0\nelement vertex 8\nelement face 1\nproperty list uchar int "
      "vertex_indices\nend_header\n3 0 1 2",
      "the vertices lack x, y or z");
  fails(std::string(ascii_square).replace(ascii_square.find("4 0 1 2 3"), 9, "4 0 1 2 4"),
        "a.ply:16: vertex index 4, but there are 4 vertices");
  fails(std::string(ascii_square).replace(ascii_square.find("4 0 1 2 3"), 9, "9 0 1 2 3"),
        "9 list entries are announced");
  const std::string whole = binary_square(std::endian::little);
  fails(whole.substr(0, whole.size() - 1), "4 list entries are announced, more than the rest");
  std::string negative = whole;
  negative[negative.size() - 1] = '\x80';
  fails(negative, "vertex index -2147483645");
  CHECK(contains(failure(whole.substr(0, whole.size() - 17), "a.ply"), "byte"));
}

TEST_CASE("PLY: no bytes crash, hang or take too much memory") {
  check_prefixes_and_mutations(ascii_square, "a.ply", 400, 31);
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    check_prefixes_and_mutations(rich(order), "a.ply", 400, 32);
  }
}

TEST_CASE("PLY: crafted files stay within the memory bound") {
  const std::string vertices =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty uchar x\nproperty uchar y\n"
      "property uchar z\nproperty uchar r\nproperty uchar g\nproperty uchar b\nproperty uchar "
      "s\nproperty uchar t\n";
  const std::string four = std::string("\0\0\0aaaaa\1\0\0aaaaa\1\1\0aaaaa\0\1\0aaaaa", 32);
  for (const std::string element : {"face", "tristrips"}) {
    std::string repeated = vertices + "element " + element +
                           " 400\nproperty list uchar uchar vertex_indices\nend_header\n" + four;
    for (int i = 0; i < 400; ++i) {
      repeated += '\xF0';
      for (int c = 0; c < 240; ++c) repeated += static_cast<char>(c % 4);
    }
    check_survives(repeated, "a.ply");
  }
  check_survives(vertices + "element face 200000\nproperty list uchar uchar vertex_indices\nend_header\n" +
                     four + std::string(200000, '\0'),
                 "a.ply");
  std::string points =
      "ply\nformat binary_little_endian 1.0\nelement vertex 100000\nproperty uchar x\nproperty uchar y\n"
      "property uchar z\nelement face 1\nproperty list uchar uchar vertex_indices\nend_header\n";
  check_survives(points + std::string(300000, '\1') + "\3" + std::string(3, '\0'), "a.ply");
  std::string header = "ply\nformat ascii 1.0\n";
  for (int i = 0; i < 20000; ++i) header += "element a 0\nproperty int b\n";
  check_survives(header + "end_header\n", "a.ply");
}

TEST_CASE("[long] PLY: many mutations") {
  Random random{33};
  for (int i = 0; i < 8000; ++i) {
    check_survives(mutated(ascii_square, random), "a.ply");
    check_survives(mutated(rich(std::endian::little), random), "a.ply");
    check_survives(mutated(rich(std::endian::big), random), "a.ply");
  }
}
