#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "reading.hpp"
#include "scene/mtl_reader.hpp"

using velum::Instance;
using velum::Mesh;
using velum::MissingNormals;
using velum::Scene;

namespace {

constexpr std::string_view square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string with_square(std::string_view rest) {
  return std::string(square) + std::string(rest);
}

const Mesh& only_mesh(const Scene& scene) {
  REQUIRE(scene.meshes().size() == 1);
  return scene.meshes()[0];
}

bool has_note(const Scene& scene, std::string_view part) {
  for (const std::string& note : scene.notes) {
    if (contains(note, part)) return true;
  }
  return false;
}

// A folder of its own for files that refer to each other; gone at the end.
struct Folder {
  std::filesystem::path path;
  explicit Folder(const std::string& name)
      : path(std::filesystem::temp_directory_path() / ("velum_obj_test_" + name)) {
    std::filesystem::create_directories(path);
  }
  ~Folder() { std::filesystem::remove_all(path); }
  void write(const std::string& name, std::string_view text) const {
    std::ofstream(path / name, std::ios::binary) << text;
  }
  Scene load(const std::string& name) const { return velum::load_scene((path / name).string()); }
};

velum::Material material(std::string_view statements) {
  velum::MaterialLibrary library;
  std::vector<std::string> notes;
  velum::read_mtl("newmtl m\n" + std::string(statements), "m.mtl", "folder", library, notes);
  return library.at("m");
}

}  // namespace

TEST_CASE("OBJ: every form of a corner, from the front and from the back") {
  const std::string lists = with_square("vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 2\n");
  for (const char* face : {"f 1 2 3", "f -4 -3 -2", "f 1/1 2/2 3/3", "f 1//1 2//1 3//1",
                           "f 1/1/1 2/2/1 3/3/1", "f -4/-3/-1 -3/-2/-1 -2/-1/-1", "f 1/ 2/ 3/",
                           "f 1// 2// 3//", "f +1 2 3 # comment", "f 1 \\\n 2 \\\r\n 3", "fo 1 2 3"}) {
    CAPTURE(face);
    const Scene scene = read(lists + face, "a.obj");
    const Mesh& mesh = only_mesh(scene);
    CHECK(mesh.positions.size() == 3);
    CHECK(mesh.positions[2] == glm::vec3(1, 1, 0));
    REQUIRE(mesh.triangles.size() == 1);
    CHECK(mesh.triangles[0] == glm::uvec3(0, 1, 2));
    CHECK(mesh.normals[0] == glm::vec3(0, 0, 1));
    const bool is_textured = contains(face, "1/1") || contains(face, "-4/");
    REQUIRE(mesh.texture_coordinates.size() == (is_textured ? 3u : 0u));
    if (is_textured) CHECK(mesh.texture_coordinates[2] == glm::vec2(1, 1));
    CHECK(scene.notes.empty());
    CHECK(mesh.name == "a");
  }
}

TEST_CASE("OBJ: indices may point forward, and vertices are shared per (v, vt, vn)") {
  const Scene scene = read("f 1 2 3\nf 1 3 4\n" + std::string(square), "a.obj");
  CHECK(only_mesh(scene).positions.size() == 4);
  const Scene seam = read(with_square("vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/1 3/2 4/1\n"), "a.obj");
  CHECK(only_mesh(seam).positions.size() == 5);
}

TEST_CASE("OBJ: polygons, concave ones too") {
  const Scene quad = read(with_square("f 1 2 3 4"), "a.obj");
  CHECK(only_mesh(quad).triangles.size() == 2);
  const Scene arrow = read("v 0 0 0\nv 2 -1 0\nv 0 3 0\nv -2 -1 0\nf 2 3 4 1\n", "a.obj");
  double area = 0.0;
  const Mesh& mesh = only_mesh(arrow);
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
    const float twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    CHECK(twice > 0.0f);
    area += static_cast<double>(twice) / 2;
  }
  CHECK(area == 6.0);
}

TEST_CASE("OBJ: runs of objects and materials become instances, in file order") {
  const Scene scene =
      read(with_square("o first\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\nusemtl red\ng x\ns 1\n"
                       "f 1 2 4\no second\nf 2 3 4\nf 1 2 3\no second\nf 1 3 4\n"),
           "a.obj");
  REQUIRE(scene.instances().size() == 4);
  const char* names[] = {"first", "first", "first", "second"};
  const char* materials[] = {"red", "blue", "red", "red"};
  const std::uint32_t first_primitives[] = {0, 1, 2, 3};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Instance& instance = scene.instances()[i];
    CHECK(instance.name == names[i]);
    CHECK(scene.meshes()[instance.mesh].name == names[i]);
    CHECK(scene.materials()[instance.material].name == materials[i]);
    CHECK(scene.first_primitive(i) == first_primitives[i]);
  }
  CHECK(scene.primitive_count() == 6);
}

TEST_CASE("OBJ: missing normals are smooth over the whole file, or flat, or fill the gaps") {
  // Two triangles folded at the edge 1-2 by a right angle, in two objects.
  const std::string fold =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 1 1\nvn 0 0 0\no a\nf 1 2 3\no b\nf 2 1 4\n";
  const Scene smooth = read(fold, "a.obj");
  const float half = static_cast<float>(std::sqrt(0.5));
  for (const Mesh& mesh : smooth.meshes()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const bool is_on_edge = mesh.positions[i].y == 0.0f && mesh.positions[i].z == 0.0f;
      if (is_on_edge)
        CHECK(mesh.normals[i] == glm::vec3(0, half, half));
      else
        CHECK(mesh.normals[i] == glm::vec3(0, mesh.positions[i].z, mesh.positions[i].y));
    }
  }
  const Scene flat = read(fold, "a.obj", MissingNormals::flat);
  for (const glm::vec3& n : flat.meshes()[0].normals) CHECK(n == glm::vec3(0, 0, 1));
  for (const glm::vec3& n : flat.meshes()[1].normals) CHECK(n == glm::vec3(0, 1, 0));
  const Scene flat_quad = read(with_square("f 1 2 3\nf 1 3 4\n"), "a.obj", MissingNormals::flat);
  CHECK(only_mesh(flat_quad).positions.size() == 6);
  // A corner's own normal stands, scaled; none, or one without direction, is filled in.
  const Scene mixed = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 3 4\nvn 0 0 0\nf 1//1 2//2 3\n", "a.obj");
  CHECK(only_mesh(mixed).normals[0] == glm::vec3(0, 0.6f, 0.8f));
  CHECK(only_mesh(mixed).normals[1] == glm::vec3(0, 0, 1));
  CHECK(only_mesh(mixed).normals[2] == glm::vec3(0, 0, 1));
}

TEST_CASE("OBJ: vertex colours are sRGB values, weights are not colours") {
  const Scene scene =
      read("v 0 0 0 1 0 0.5\nv 1 0 0 0.04045 0 0 0.25\nv 0 1 0\nv 0 0 1 0.5\nf 1 2 3 4\n", "a.obj");
  CHECK(scene.materials()[0].base_colour == glm::vec3(1.0f));
  const Mesh& mesh = only_mesh(scene);
  REQUIRE(mesh.colours.size() == 4);
  CHECK(mesh.colours[0].x == 1.0f);
  CHECK(mesh.colours[0].y == 0.0f);
  CHECK(mesh.colours[0].z == doctest::Approx(0.2140411).epsilon(1e-6));
  CHECK(mesh.colours[0].w == 1.0f);
  CHECK(mesh.colours[1].x == doctest::Approx(0.04045 / 12.92).epsilon(1e-6));
  CHECK(mesh.colours[1].w == 0.25f);
  CHECK(mesh.colours[2] == glm::vec4(1.0f));
  CHECK(mesh.colours[3] == glm::vec4(1.0f));
  CHECK(only_mesh(read("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n", "a.obj")).colours.empty());
}

TEST_CASE("OBJ: what is left out is told") {
  const Scene scene = read(with_square("l 1\nl\np\nf 1 2\nbevel on\nf 1 2 3\nmtllib none.mtl\n"), "a.obj");
  CHECK(has_note(scene, "2 line elements (l) with fewer than two vertices"));
  CHECK(has_note(scene, "1 faces with fewer than three corners"));
  CHECK(has_note(scene, "the first is \"bevel\" in line 9"));
  CHECK(has_note(scene, "the first is \"none.mtl\""));
  CHECK(scene.primitive_count() == 1);
  const Scene cloud = read(square, "a.obj");
  CHECK(has_note(cloud, "no faces: its vertices are drawn as points"));
  CHECK(only_mesh(cloud).positions.size() == 4);
  CHECK(cloud.primitive_count() == 4);
  CHECK(only_mesh(cloud).points[3] == 3);
  CHECK(has_note(read("vn 0 0 1\n", "a.obj"), "nothing to draw"));
  CHECK(has_note(read("v nan 0 0\nv 1e99 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj"),
                 "2 vertex positions are not finite"));
}

TEST_CASE("OBJ: line and point elements follow their object's faces, with its material and without normals") {
  const Scene scene =
      read(with_square("o a\nl 1 2/1 -1\nf 1 2 3\np 4 1\no b\nusemtl m\nl 3 4\nvt 0 0\n"), "a.obj");
  REQUIRE(scene.instances().size() == 3);
  CHECK(scene.meshes()[0].triangles.size() == 1);
  CHECK(scene.meshes()[0].primitive_count() == 1);
  const Mesh& lines = scene.meshes()[1];
  CHECK(lines.name == "a");
  CHECK(lines.normals.empty());
  REQUIRE(lines.segments.size() == 2);
  CHECK(lines.positions[lines.segments[0].y] == scene.meshes()[0].positions[1]);
  CHECK(lines.segments[0].y == lines.segments[1].x);
  REQUIRE(lines.points.size() == 2);
  CHECK(lines.points[0] == lines.segments[1].y);
  CHECK(scene.meshes()[2].segments.size() == 1);
  CHECK(scene.meshes()[2].positions.size() == 2);
  CHECK(scene.instances()[2].name == "b");
  CHECK(scene.instances()[2].material == 1);
  CHECK(scene.primitive_count() == 6);
  CHECK(contains(failure(with_square("l 1 5\n"), "a.obj"), "a.obj:5: index 5, but the file has 4 vertices"));
  CHECK(contains(failure(with_square("p 0\n"), "a.obj"), "a.obj:5: the index 0"));
}

TEST_CASE("OBJ: mistakes name the line and what to do") {
  const auto fails = [](std::string_view text, std::string_view part) {
    CAPTURE(text);
    const std::string message = failure(text, "a.obj");
    CAPTURE(message);
    CHECK(contains(message, part));
  };
  fails("v 0 0 0\nv 1 x 0\n", "a.obj:2: a coordinate is not a number: \"x\"");
  fails("v 0 0\n", "a.obj:1: a vertex needs three coordinates");
  fails(with_square("f 1 2 0\n"), "a.obj:5: the index 0");
  fails(with_square("\nf 1 2 9\n"), "a.obj:6: index 9, but the file has 4 vertices");
  fails(with_square("f 1 2 -5\n"), "a.obj:5: the index -5");
  fails(with_square("f 1/1 2/1 3/1\n"), "a.obj:5: index 1, but the file has 0 texture coordinates");
  fails(with_square("f 1//2 2//2 3//2\nvn 0 0 1\n"), "a.obj:5: index 2, but the file has 1 normals");
  fails(with_square("f 1 2 3,4\n"), "not of the form");
  fails(with_square("f 1 2 99999999999\n"), "too large");
  fails(with_square("f 1 2 99999999999999999999\n"), "not a whole number");
  fails("this is\nnot a mesh\n", "no line is an OBJ statement");
  std::string large, face = "f";
  for (int i = 0; i < 9000; ++i) {
    large += "v " + std::to_string(i) + " " + std::to_string(i % 2) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  fails(large + "v 4500 -9 0\n" + face + " 9001\n", "a.obj:9002: a concave polygon with 9001 corners");
}

TEST_CASE("MTL: what each statement means") {
  CHECK(material("Kd 0.5 0.25 0").base_colour == glm::vec3(0.5f, 0.25f, 0.0f));
  CHECK(material("Kd 0.5").base_colour == glm::vec3(0.5f));
  CHECK(material("Kd 0.5").diffuse == glm::vec3(1.0f));
  CHECK(material("Kd 0.5\nKa 0 0 0").ambient == glm::vec3(1.0f));
  CHECK(material("Kd 0.5\nKa 1 1 1").ambient == glm::vec3(1.0f));
  CHECK(material("Ka 0.1 0.2 0.3\nKd 0.4 0.4 0").ambient == glm::vec3(0.25f, 0.5f, 1.0f));
  CHECK(material("Ks 0.5 0.5 0.5\nNs 10").specular == glm::vec3(0.5f));
  CHECK(material("Ns 10").shininess == 10.0f);
  CHECK(material("Ks 1\nillum 1").specular == glm::vec3(0.0f));
  CHECK(material("d 0.25").alpha == 0.25f);
  CHECK(material("Tr 0.25").alpha == 0.75f);
  CHECK(material("Tr 1\nd 1").alpha == 1.0f);
  CHECK(material("d 7").alpha == 1.0f);
  CHECK(material("Ni 1.5").refractive_index == 1.5f);
  CHECK(material("Ni 0").refractive_index == 1.0f);
  CHECK(material("illum 3\nKs 0.25 0.5 0").mirror_share == 0.5f);
  CHECK(material("illum 2\nKs 0.5").mirror_share == 0.0f);
  CHECK(material("illum 6\nTf 0.5 0.25 0").transmission_share == 0.5f);
  CHECK(material("illum 9\nd 0.25").transmission_share == 0.75f);
  CHECK(material("map_Kd a picture.png").base_colour_texture == "folder/a picture.png");
  CHECK(material("map_Kd -s 2 2 -o 1 -clamp on -mm 0 1 sub\\t.png").base_colour_texture ==
        "folder/sub/t.png");
  CHECK(material("map_Kd C:\\art\\t.png").base_colour_texture == "folder/t.png");
  CHECK(material("Kd spectral x.rfl").base_colour == velum::Material{}.base_colour);
  velum::MaterialLibrary library;
  std::vector<std::string> notes;
  CHECK_THROWS_WITH_AS(velum::read_mtl("newmtl a\nKd red\n", "a.mtl", {}, library, notes),
                       doctest::Contains("a.mtl:2: a colour is not a number"), velum::Error);
  velum::read_mtl("newmtl a\nmap_Bump b.png\nmap_Ks c.png\n", "a.mtl", {}, library, notes);
  REQUIRE(notes.size() == 1);
  CHECK(contains(notes[0], "2 material statements are left out, the first is \"map_Bump\" at a.mtl:2"));
}

TEST_CASE("OBJ: libraries beside the file, with blanks in names, several in a line, or missing") {
  const Folder folder("libraries");
  folder.write("one.mtl", "newmtl red\nKd 1 0 0\n");
  folder.write("two.mtl", "newmtl Dark  Blue \nKd 0 0 0.5\nmap_Kd b.png\n");
  folder.write("a name.mtl", "newmtl green\nKd 0 1 0\n");
  folder.write("a.obj",
               with_square("mtllib ./one.mtl two.mtl\nmtllib /elsewhere/a name.mtl\nusemtl red\nf 1 2 3\n"
                           "usemtl Dark  Blue\nf 1 2 4\nusemtl green\nf 1 3 4\nusemtl none\nf 2 3 4\n"));
  const Scene scene = folder.load("a.obj");
  REQUIRE(scene.materials().size() == 5);
  CHECK(scene.materials()[1].base_colour == glm::vec3(1, 0, 0));
  CHECK(scene.materials()[2].base_colour == glm::vec3(0, 0, 0.5f));
  CHECK(std::filesystem::path(scene.materials()[2].base_colour_texture) == folder.path / "b.png");
  CHECK(scene.materials()[3].base_colour == glm::vec3(0, 1, 0));
  CHECK(scene.materials()[4].base_colour == velum::Material{}.base_colour);
  CHECK(scene.materials()[4].name == "none");
  REQUIRE(scene.notes.size() == 2);
  CHECK(contains(scene.notes[0], "no library has the material \"none\""));
  CHECK(contains(scene.notes[1], "b.png"));  // is not there
}

TEST_CASE("OBJ: a broken library costs its materials from the fault on, not the mesh") {
  const Folder folder("broken");
  folder.write("a.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 one\nnewmtl green\nKd 0 1 0\n");
  folder.write("b.mtl", "Kd 1 0 0\n");
  folder.write("c.mtl", "newmtl white\nKd 1 1 1\n");
  folder.write("a.obj", with_square("mtllib a.mtl b.mtl c.mtl\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 2 4\n"
                                    "usemtl white\nf 1 3 4\n"));
  const Scene scene = folder.load("a.obj");
  REQUIRE(scene.materials().size() == 4);
  CHECK(scene.materials()[1].base_colour == glm::vec3(1, 0, 0));
  CHECK(scene.materials()[2].base_colour == velum::Material{}.base_colour);
  CHECK(scene.materials()[3].base_colour == glm::vec3(1, 1, 1));
  REQUIRE(scene.notes.size() == 2);
  CHECK(has_note(scene, "2 material libraries are read only as far as a fault, the first is"));
  CHECK(has_note(scene, "a.mtl:4: a colour is not a number"));
  CHECK(has_note(scene, "no library has the material \"blue\""));
}

TEST_CASE("OBJ: a library that is named in two ways is read once") {
  const Folder folder("twice");
  folder.write("a.mtl", "newmtl red\nKd 1 0 0\nmap_Bump b.png\n");
  folder.write("a.obj", with_square("mtllib a.mtl\nmtllib ./a.mtl .//a.mtl\nusemtl red\nf 1 2 3\n"));
  const Scene scene = folder.load("a.obj");
  REQUIRE(scene.notes.size() == 1);  // of what is left out
  CHECK(contains(scene.notes[0], "map_Bump"));
}

TEST_CASE("OBJ: no bytes crash, hang or take too much memory") {
  const std::string text = with_square(
      "vt 0 0\nvn 0 0 1\nmtllib a.mtl\no a\nusemtl m\nf 1/1/1 2//1 3/1 4\nf -1 -2 -3\nl 1 2\n"
      "v 0.5 .5 1e-3 1 0.5 0\nf 1 2 5 \\\n 3 4\n# end\n");
  check_prefixes_and_mutations(text, "a.obj", 400, 11);
}

TEST_CASE("OBJ: crafted files stay within the memory bound") {
  const auto repeated = [](std::string_view part, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += part;
    return text;
  };
  const std::string coloured = "v 0 0 0 1 1 1\nv 1 0 0\nv 0 1 0\nv 1 1 1\nvt 0 0\nvn 0 0 1\n";
  check_survives(coloured + "f" + repeated(" 1 2 3", 100000), "a.obj");
  check_survives(coloured + "f" + repeated(" 1 2 4 3", 2000), "a.obj");
  check_survives(coloured + repeated("f 1 2 3 4 1 2 3 4 1 2 3 4\n", 20000), "a.obj");
  check_survives(coloured + repeated("o\nf 1 2 3\no a\nf 1 2 3\n", 20000), "a.obj");
  check_survives(coloured + "o " + std::string(5000, 'x') + "\n" +
                     repeated("usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n", 5000),
                 "a.obj");
  check_survives(coloured + repeated("v 1 1 1\n", 50000) + "f 1 2 3\n", "a.obj");
  check_survives(coloured + repeated("vt 1\nvn 1 1 1\n", 50000) + "f 1 2 3\n", "a.obj");
  check_survives(coloured + repeated("f 1 1 1\n", 50000), "a.obj");
  check_survives(coloured + repeated("f 1/1/1 2/1/1 3/1/1\n", 30000), "a.obj");
  check_survives(repeated("mtllib a\n", 50000), "a.obj");
  std::string distinct(coloured), names(coloured);
  for (int i = 0; i < 400; ++i) distinct += "vt 1\n";
  for (int i = 1; i <= 100000; ++i) {
    distinct += (i % 50 == 1 ? "\nf " : " ") + std::to_string(1 + i % 4) + "/" + std::to_string(1 + i % 401);
    if (i <= 20000) names += "usemtl " + std::to_string(i) + "\nf 1 2 3\n";
  }
  check_survives(distinct, "a.obj");
  check_survives(names, "a.obj");
}

TEST_CASE("[long] OBJ: many mutations") {
  Random random{12};
  const std::string text = with_square("vt 0 0\nvn 0 0 1\no a\nusemtl m\nf 1/1/1 2//1 3/1 4\nf 1 2 4 3\n");
  for (int i = 0; i < 20000; ++i) check_survives(mutated(mutated(text, random), random), "a.obj");
}
