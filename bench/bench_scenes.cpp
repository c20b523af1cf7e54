#include "bench_scenes.hpp"

#include <array>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

namespace velum_bench {
namespace {

using namespace velum;
using nlohmann::json;

glm::dvec3 vector_of(const json& value) {
  return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

Camera camera_of(const json& value) {
  const Pose pose =
      Pose::towards(vector_of(value.at("eye")), vector_of(value.at("target")), vector_of(value.at("up")));
  const double opening = value.at("fovy_deg").get<double>() * std::numbers::pi / 180.0;
  return Camera::perspective(pose, {VerticalAngle{opening}}, value.at("near").get<double>(),
                             value.at("far").get<double>());
}

/// The vertices on the middles of edges, each edge once.
class Midpoints {
 public:
  explicit Midpoints(std::vector<glm::vec3>& positions) : positions_(positions) {}
  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    const auto [entry, is_new] =
        of_edge_.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(positions_.size()));
    if (is_new) positions_.push_back((positions_[a] + positions_[b]) * 0.5f);
    return entry->second;
  }

 private:
  std::vector<glm::vec3>& positions_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> of_edge_;
};

/// Every triangle in four at the middles of its edges.
Mesh subdivided(const Mesh& mesh) {
  std::vector<glm::vec3> positions(mesh.positions.begin(), mesh.positions.end());
  std::vector<glm::uvec3> triangles;
  triangles.reserve(mesh.triangles.size() * 4);
  Midpoints midpoints(positions);
  for (const glm::uvec3& t : mesh.triangles) {
    const std::uint32_t ab = midpoints.between(t.x, t.y);
    const std::uint32_t bc = midpoints.between(t.y, t.z);
    const std::uint32_t ca = midpoints.between(t.z, t.x);
    triangles.insert(triangles.end(), {{t.x, ab, ca}, {ab, t.y, bc}, {ca, bc, t.z}, {ab, bc, ca}});
  }
  Mesh result;
  result.name = mesh.name;
  result.positions = std::move(positions);
  result.triangles = std::move(triangles);
  return result;
}

Scene sixteen_times_finer(const Scene& scene) {
  Scene result;
  result.add(subdivided(subdivided(scene.meshes().front())));
  return result;
}

/// 10 × 10 × 10 instances, 1.2 boxes apart.
Scene thousand_times(const Scene& scene) {
  Scene result;
  const std::uint32_t mesh = result.add_mesh(scene.meshes().front());
  const Aabb box = bounds(scene.meshes().front());
  const glm::dvec3 step = (glm::dvec3(box.upper) - glm::dvec3(box.lower)) * 1.2;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 offset = step * (glm::dvec3(i % 10, i / 10 % 10, i / 100) - 4.5);
    Instance instance;
    instance.mesh = mesh;
    instance.world_from_object[3] = glm::dvec4(offset, 1.0);
    result.add_instance(instance);
  }
  return result;
}

/// 32 quads over the whole picture at distances 1.5, 2.0, … 17.0.
Scene filling_quads(bool back_to_front, const Camera& camera, double aspect) {
  const double slope =
      std::get<VerticalAngle>(std::get<PerspectiveLens>(camera.lens()).opening).radians / 2.0;
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  for (int i = 0; i < 32; ++i) {
    const double distance = 1.5 + 0.5 * (back_to_front ? 31 - i : i);
    const double y = 1.01 * distance * std::tan(slope), x = y * aspect;
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const auto& [sx, sy] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      positions.emplace_back(sx * x, sy * y, -distance);
    triangles.insert(triangles.end(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
  }
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(triangles);
  Scene scene;
  scene.add(std::move(mesh));
  return scene;
}

struct Recipe {
  const char* name;
  const char* file;
};
constexpr std::array<Recipe, 7> recipes{{{"bunny", "stanford-bunny.obj"},
                                         {"castle", "castle.ply"},
                                         {"sponza", "sponza.ply"},
                                         {"bunny16", "stanford-bunny.obj"},
                                         {"fill32_f2b", ""},
                                         {"fill32_b2f", ""},
                                         {"bunnies1000", "stanford-bunny.obj"}}};

Scene scene_of(const Recipe& recipe, const std::filesystem::path& data, const Camera& camera) {
  const std::string name = recipe.name;
  if (name == "fill32_f2b" || name == "fill32_b2f")
    return filling_quads(name == "fill32_b2f", camera, 1920.0 / 1080.0);
  Scene scene = load_scene(data / recipe.file);
  if (name == "bunny16") return sixteen_times_finer(scene);
  if (name == "bunnies1000") return thousand_times(scene);
  return scene;
}

}  // namespace

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const Recipe& recipe : recipes) names.emplace_back(recipe.name);
  return names;
}

std::optional<BenchScene> make_scene(const std::string& name, const std::filesystem::path& data) {
  for (const Recipe& recipe : recipes) {
    if (name != recipe.name) continue;
    if (!std::filesystem::exists(data / recipe.file)) return {};
    std::ifstream file(data / "benchmark_cameras.json");
    if (!file) return {};
    const Camera camera = camera_of(json::parse(file).at(name));
    return BenchScene{name, scene_of(recipe, data, camera), camera};
  }
  throw Error(ErrorKind::usage, "there is no scene \"" + name + "\"", "--scene",
              "see --help for their names");
}

}  // namespace velum_bench
