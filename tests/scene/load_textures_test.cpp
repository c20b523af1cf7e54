#include "scene/load_textures.hpp"

#include <filesystem>
#include <fstream>
#include <memory>

#include "image/files.hpp"
#include "reading.hpp"
#include "scene/mtl_reader.hpp"

using velum::Scene;
using velum::TextureWrap;

namespace {

namespace fs = std::filesystem;

/// A folder that is empty at the start and gone at the end.
struct Folder {
  fs::path path = fs::temp_directory_path() / "velum_load_textures_test";
  Folder() {
    fs::remove_all(path);
    fs::create_directories(path / "art");
  }
  ~Folder() { fs::remove_all(path); }
  void write(const std::string& name, std::string_view text) const {
    std::ofstream(path / name, std::ios::binary) << text;
  }
  Scene load(std::string_view library) const {
    write("a.mtl", library);
    std::string text = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
    for (const char* name : {"one", "two"}) text += std::string("usemtl ") + name + "\nf 1/1 2/2 3/3\n";
    write("a.obj", text);
    return velum::load_scene((path / "a.obj").string());
  }
};

velum::Image<velum::Rgba8> two_texels() {
  velum::Image<velum::Rgba8> picture(2, 1);
  picture.at(0, 0) = {255, 0, 0, 255};
  picture.at(1, 0) = {0, 0, 255, 128};
  return picture;
}

velum::TextureMapping mapping(std::string_view options) {
  velum::MaterialLibrary library;
  std::vector<std::string> notes;
  velum::read_mtl("newmtl m\nmap_Kd " + std::string(options) + " t.png\n", "m.mtl", "folder", library, notes);
  CHECK(library.at("m").base_colour_texture == "folder/t.png");
  return library.at("m").texture_mapping;
}

}  // namespace

TEST_CASE("map_Kd is loaded from beside the library, once for all materials that name it") {
  const Folder folder;
  velum::write_png(folder.path / "art" / "a b.png", two_texels());
  velum::write_ppm(folder.path / "c.ppm", two_texels());
  Scene scene =
      folder.load("newmtl one\nmap_Kd art/a b.png\nnewmtl two\nKd .5 .5 .5\nmap_Kd ./art/../art\\a b.png\n");
  CHECK(scene.notes.empty());
  REQUIRE(scene.materials().size() == 3);
  const velum::Material &one = scene.materials()[1], &two = scene.materials()[2];
  REQUIRE(one.texture);
  CHECK(one.texture->width() == 2);
  CHECK(one.texture->level(0).at(0, 0) == glm::vec4(1, 0, 0, 1));
  CHECK(one.texture == two.texture);
  CHECK(one.base_colour == glm::vec3(1.0f));
  CHECK(two.base_colour == glm::vec3(0.5f));
  scene = folder.load("newmtl one\nmap_Kd c.ppm\nnewmtl two\n");
  REQUIRE(scene.materials()[1].texture);
  CHECK(scene.materials()[1].texture->is_opaque());
  CHECK_FALSE(scene.materials()[2].texture);
}

TEST_CASE("textures that are missing, broken, foreign or no files are told in a note") {
  const Folder folder;
  folder.write("broken.png", "\x89PNG and then nothing");
  folder.write("t.gif", "GIF89a");
  Scene scene = folder.load("newmtl one\nmap_Kd nothere.png\nnewmtl two\nmap_Kd nothere.png\n");
  CHECK_FALSE(scene.materials()[1].texture);
  REQUIRE(scene.notes.size() == 1);
  CHECK(contains(scene.notes[0], "1 texture is left out, the first because of "));
  CHECK(contains(scene.notes[0], "nothere.png: there is no such picture"));
  scene = folder.load("newmtl one\nmap_Kd broken.png\nnewmtl two\nmap_Kd art\n");
  REQUIRE(scene.notes.size() == 1);
  CHECK(contains(scene.notes[0], "2 textures are left out"));
  CHECK(contains(scene.notes[0], "broken.png"));
  scene = folder.load("newmtl one\nmap_Kd t.gif\nnewmtl two\n");
  CHECK(contains(scene.notes.at(0), "no picture format that is known"));
}

TEST_CASE("MTL: -clamp, -o and -s of map_Kd") {
  const velum::TextureMapping plain = mapping("");
  CHECK(plain.wrap[0] == TextureWrap::repeat);
  CHECK(plain.scale == glm::vec2(1.0f));
  const velum::TextureMapping all = mapping("-clamp on -o 0.5 0.25 9 -s 2 3 1 -mm 0 1 -t 1 1 1 -blendu on");
  CHECK(all.wrap[0] == TextureWrap::clamp);
  CHECK(all.wrap[1] == TextureWrap::clamp);
  CHECK(all.offset == glm::vec2(0.5f, 0.25f));
  CHECK(all.scale == glm::vec2(2.0f, 3.0f));
  CHECK(mapping("-s 2").scale == glm::vec2(2.0f, 1.0f));
  CHECK(mapping("-clamp off").wrap[0] == TextureWrap::repeat);
}

TEST_CASE("a texture belongs to the scene's revision") {
  Scene scene;
  velum::Material material;
  const std::uint32_t index = scene.add_material(material);
  material.texture = std::make_shared<const velum::Texture>(two_texels());
  const std::uint64_t before = scene.revision();
  Scene other = scene;
  scene.set_material(index, material);
  CHECK(scene.revision() != before);
  material.texture_mapping.wrap[1] = TextureWrap::mirror;
  other.set_material(index, material);
  CHECK(other.revision() != scene.revision());
}

TEST_CASE("builtin:checkerboard has a texture of unit cells") {
  const Scene scene = velum::load_scene("builtin:checkerboard");
  REQUIRE(scene.instances().size() == 1);
  const velum::Mesh& mesh = scene.meshes()[0];
  REQUIRE(scene.materials()[scene.instances()[0].material].texture);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    CHECK(mesh.texture_coordinates[i].x * 2.0f == mesh.positions[i].x + 128.0f);
    CHECK(mesh.texture_coordinates[i].y * 2.0f == 128.0f - mesh.positions[i].z);
  }
}
