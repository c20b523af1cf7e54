#include "scene/load_scene.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "reading.hpp"

namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// Loads or throws Error (read). @return whether it loaded
bool loads(const fs::path& path) {
  try {
    velum::load_scene(path.string());
    return true;
  } catch (const velum::Error& error) {
    CHECK(error.kind() == velum::ErrorKind::read);
    return false;
  }
}

}  // namespace

TEST_CASE("built-in shapes are scenes") {
  const velum::Scene scene = velum::load_scene("builtin:cube");
  CHECK(scene.instances().size() == 1);
  CHECK(scene.primitive_count() == 12);
  CHECK_THROWS_AS(velum::load_scene("builtin:nothing"), velum::Error);
}

TEST_CASE("a file that is not there is an Error (read) with its name") {
  try {
    velum::load_scene("nothere.obj");
    FAIL("it was loaded");
  } catch (const velum::Error& error) {
    CHECK(error.kind() == velum::ErrorKind::read);
    CHECK(contains(error.what(), "nothere.obj"));
  }
}

TEST_CASE("content decides before the extension, and what is foreign is named") {
  CHECK(read("# a comment\n\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.stl.txt").primitive_count() == 1);
  CHECK(contains(failure("", "a.obj"), "the file is empty"));
  CHECK(contains(failure("OFF\n1 2 3\n", "a.off"), "an OFF file; OBJ, STL and PLY are read"));
  CHECK(contains(failure("glTF\x02", "a.glb"), "a glTF binary"));
  CHECK(contains(failure(std::string("\xFE\xFF\0v", 4), "a.obj"), "text in UTF-16"));
  CHECK(contains(failure("hello world\n", "a.txt"), "neither content nor name"));
  CHECK(read("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "-").primitive_count() == 1);
}

TEST_CASE("Debian's test models are read or refused, never worse") {
  const fs::path models = "/usr/share/assimp/models";
  if (!fs::exists(models)) {
    MESSAGE("assimp-testmodels is not installed: skipped");
    return;
  }
  const std::pair<const char*, std::vector<std::string>> refused[] = {
      {"OBJ", {"box_UTF16BE.obj", "number_formats.obj"}},  // 3.1+e2 is no number
      {"PLY", {"issue623.ply", "pond.0.ply"}},  // a list in the header that is not in the data; cut off
      {"STL", {}},
      {"invalid", {"empty.obj", "empty.ply", "malformed.obj"}}};
  for (const auto& [folder, expected] : refused) {
    std::vector<std::string> failed;
    for (const fs::path& path : files_in(models / folder)) {
      const std::string extension = path.extension().string();
      if (extension != ".obj" && extension != ".ply" && extension != ".stl" && extension != ".STL") continue;
      if (!loads(path)) failed.push_back(path.filename().string());
    }
    std::string names;
    for (const std::string& one : failed) names += one + " ";
    CAPTURE(names);
    CHECK(failed == expected);
  }
}

TEST_CASE("glmark2's bunny") {
  const fs::path path = "/usr/share/glmark2/models/bunny.obj";
  if (!fs::exists(path)) {
    MESSAGE("glmark2-data is not installed: skipped");
    return;
  }
  CHECK(velum::load_scene(path.string()).primitive_count() > 10000);
}

TEST_CASE("the shared meshes have their triangles") {
  const fs::path data = VELUM_SHARED_DATA;
  if (!fs::exists(data)) {
    MESSAGE("the shared meshes are not beside the project: skipped");
    return;
  }
  const std::pair<const char*, std::uint32_t> meshes[] = {
      {"stanford-bunny.obj", 69451}, {"sponza.ply", 262267}, {"castle.ply", 48700},
      {"teapot.obj", 6320},          {"suzanne.obj", 968},   {"cow.obj", 5804}};
  for (const auto& mesh : meshes) {
    CAPTURE(mesh.first);
    const velum::Scene scene = velum::load_scene((data / mesh.first).string());
    CHECK(scene.primitive_count() == mesh.second);
    CHECK(scene.notes.empty());
  }
}

TEST_CASE("[long] mutated real files are read or refused") {
  Random random{41};
  for (const char* folder : {"OBJ", "PLY", "STL"}) {
    for (const fs::path& path : files_in(fs::path("/usr/share/assimp/models") / folder)) {
      const std::string text = content(path);
      if (text.size() > 60000) continue;
      for (int i = 0; i < 40; ++i)
        check_survives(mutated(mutated(text, random), random), path.filename().string());
    }
  }
}
