#include "subjects.hpp"

#include <filesystem>

namespace velum_gallery {
namespace {

using namespace velum;

struct Source {
  const char* stem;
  const char* title;
  const char* input;  ///< as for load_scene
  Rgba8 colour;       ///< of what has no material of its own
  UpAxis up = UpAxis::y;
};

const Source sources[] = {
    {"letter-f", "Letter F", "builtin:letter-f", {226, 138, 90}},
    {"house", "House", "builtin:house", {214, 190, 150}},
    {"cube", "Cube", "builtin:cube", {124, 170, 214}},
    {"bunny", "Bunny (glmark2-data)", "/usr/share/glmark2/models/bunny.obj", {214, 204, 190}},
    {"spider", "Spider (assimp-testmodels, OBJ)", "/usr/share/assimp/models/OBJ/spider.obj", {190, 190, 200}},
    {"wuson", "Wuson (assimp-testmodels, PLY)", "/usr/share/assimp/models/PLY/Wuson.ply", {170, 196, 160}},
    {"sphere-with-hole",
     "Sphere with a hole (assimp-testmodels, STL)",
     "/usr/share/assimp/models/STL/sphereWithHole.stl",
     {214, 150, 160},
     UpAxis::z},
    {"stairs", "Stairs", "builtin:stairs", {200, 184, 120}},
    {"torus", "Torus", "builtin:torus", {150, 200, 190}},
    {"icosahedron", "Icosahedron", "builtin:icosahedron", {190, 160, 214}},
};

bool is_file(const std::string& input) {
  return !input.starts_with("builtin:");
}

/// Gives the default material the source's colour, unless the mesh has colours; a file's own materials stay.
void tint(Scene& scene, const Rgba8& colour) {
  if (!scene.meshes().empty() && !scene.meshes()[0].colours.empty()) return;
  Material material = scene.materials()[0];
  material.base_colour = glm::vec3(linear_from_srgb(colour));
  scene.set_material(0, material);
}

}  // namespace

std::vector<Subject> load_subjects(std::vector<std::string>& skipped) {
  std::vector<Subject> subjects;
  for (const Source& source : sources) {
    const std::string input = source.input;
    std::error_code ignored;
    if (is_file(input) && !std::filesystem::exists(input, ignored)) {
      skipped.push_back(input);
      continue;
    }
    Subject subject{source.stem, source.title, load_scene(input)};
    subject.scene.up = source.up;
    tint(subject.scene, source.colour);
    subjects.push_back(std::move(subject));
  }
  return subjects;
}

}  // namespace velum_gallery
