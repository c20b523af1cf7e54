#include "scenes.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string_view>
#include <utility>

#include "meshes.hpp"

namespace velum_bench {
namespace {

using namespace velum;
using nlohmann::json;

constexpr double degrees = std::numbers::pi / 180.0;
constexpr double fill_angle = 45.0 * degrees;
constexpr const char* camera_file = "benchmark_cameras.json";

/// What a scene is made of. A mesh file's scene has its camera in camera_file.
struct Recipe {
  std::string_view name;
  const char* mesh_file;  ///< empty: built in
  Scene (*make)(Mesh mesh);
};

Scene one(Mesh mesh) {
  Scene scene;
  scene.add(std::move(mesh));
  return scene;
}
Scene sixteen_times_finer(Mesh mesh) {
  return one(subdivided(subdivided(mesh)));
}
Scene quads(bool back_to_front) {
  return one(filling_quads(back_to_front, fill_angle, 1920.0 / 1080.0));
}

constexpr std::array<Recipe, 11> recipes{{
    {"bunny", "stanford-bunny.obj", one},
    {"castle", "castle.ply", one},
    {"sponza", "sponza.ply", one},
    {"bunny16", "stanford-bunny.obj", sixteen_times_finer},
    {"fill32_f2b", "", [](Mesh) { return quads(false); }},
    {"fill32_b2f", "", [](Mesh) { return quads(true); }},
    {"bunnies1000", "stanford-bunny.obj", thousand_times},
    {"builtin-sphere", "", [](Mesh) { return one(sphere_of(69'451)); }},
    {"builtin-terrain", "", [](Mesh) { return one(terrain_of(262'267)); }},
    {"builtin-sphere16", "", [](Mesh) { return one(sphere_of(1'111'216)); }},
    {"builtin-spheres1000", "", [](Mesh) { return thousand_times(sphere_of(69'451)); }},
}};

bool is_built_in(const Recipe& recipe) {
  return recipe.name.starts_with("builtin-");
}
bool has_file(const Recipe& recipe) {
  return recipe.mesh_file[0] != '\0';
}
bool is_there(const Recipe& recipe, const std::filesystem::path& data) {
  return !has_file(recipe) ||
         (std::filesystem::exists(data / recipe.mesh_file) && std::filesystem::exists(data / camera_file));
}

Camera looking(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up, double angle,
               double near, double far) {
  return Camera::perspective(Pose::towards(eye, target, up), {VerticalAngle{angle}}, near, far);
}

glm::dvec3 vector_of(const json& value) {
  return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

Camera camera_in_file(const Recipe& recipe, const std::filesystem::path& file) {
  try {
    std::ifstream stream(file);
    const json value = json::parse(stream).at(std::string(recipe.name));
    return looking(vector_of(value.at("eye")), vector_of(value.at("target")), vector_of(value.at("up")),
                   value.at("fovy_deg").get<double>() * degrees, value.at("near").get<double>(),
                   value.at("far").get<double>());
  } catch (const json::exception& error) {
    throw Error(ErrorKind::read,
                "the camera of \"" + std::string(recipe.name) + "\" cannot be read: " + error.what(),
                file.string(), "take the file that belongs to the benchmark meshes");
  }
}

/// As the files' cameras: a mesh fills the height, the terrain is seen from just above it, the thousand from
/// outside.
Camera built_in_camera(std::string_view name) {
  if (name.starts_with("fill32")) return looking({}, {0, 0, -1}, {0, 1, 0}, fill_angle, 1.0, 20.0);
  if (name == "builtin-terrain")
    return looking({0.9, 0.3, 0.9}, {0.0, 0.0, 0.0}, {0, 1, 0}, 60.0 * degrees, 0.01, 10.0);
  if (name == "builtin-spheres1000")
    return looking({24, 19, 29}, {0, 0, 0}, {0, 1, 0}, fill_angle, 2.0, 200.0);
  return looking({1.2, 0.9, 2.4}, {0, 0, 0}, {0, 1, 0}, fill_angle, 0.1, 10.0);
}

}  // namespace

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const Recipe& recipe : recipes) names.emplace_back(recipe.name);
  return names;
}

std::vector<std::string> default_scene_names(const std::filesystem::path& data) {
  const bool has_data = std::any_of(recipes.begin(), recipes.end(), [&](const Recipe& recipe) {
    return has_file(recipe) && is_there(recipe, data);
  });
  std::vector<std::string> names;
  for (const Recipe& recipe : recipes) {
    if (is_there(recipe, data) && !(has_data && is_built_in(recipe))) names.emplace_back(recipe.name);
  }
  return names;
}

std::optional<BenchScene> make_scene(const std::string& name, const std::filesystem::path& data) {
  for (const Recipe& recipe : recipes) {
    if (name != recipe.name) continue;
    if (!is_there(recipe, data)) return {};
    if (!has_file(recipe)) return BenchScene{name, recipe.make({}), built_in_camera(name)};
    Mesh mesh = without_attributes(load_scene(data / recipe.mesh_file).meshes().front());
    return BenchScene{name, recipe.make(std::move(mesh)), camera_in_file(recipe, data / camera_file)};
  }
  throw Error(ErrorKind::usage, "there is no scene \"" + name + "\"", "--scene",
              "see --help for their names");
}

}  // namespace velum_bench
