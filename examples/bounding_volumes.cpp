// One volume around a mesh: its surface, how many lines meet it and how many of those meet the mesh, and the
// time it takes to ask.
#include <velum/raycast/brute_force/bounded_brute_force.hpp>
#include <velum/spatial/convex_hull.hpp>
#include <velum/velum.hpp>

#include <cstdint>
#include <cstdio>
#include <ctime>
#include <glm/geometric.hpp>

namespace {

/// Lines in every direction, all over a disc that hides a box from that direction.
std::vector<velum::Ray> lines_through(const velum::Aabb& box, int count) {
  std::uint64_t state = 1;
  const auto next = [&state] {  // in [-1, 1)
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 11) * 0x1.0p-52 - 1.0;
  };
  const double radius = 0.5 * glm::length(box.size());
  std::vector<velum::Ray> lines;
  while (static_cast<int>(lines.size()) < count) {
    const glm::dvec3 direction(next(), next(), next());
    if (glm::dot(direction, direction) > 1.0 || glm::dot(direction, direction) < 0.01) continue;
    const glm::dvec3 n = glm::normalize(direction);
    const glm::dvec3 across =
        glm::normalize(glm::cross(n, n.x * n.x < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const double u = next(), v = next();
    lines.push_back({box.centre() + radius * (across * u + glm::cross(n, across) * v - 3.0 * n), n});
  }
  return lines;
}

}  // namespace

int main(int argc, char** argv) {
  const velum::Scene scene = velum::load_scene(argc > 1 ? argv[1] : "builtin:house");
  const velum::Mesh& mesh = scene.meshes()[0];
  const auto tree =
      velum::build_accelerator(velum::AcceleratorKind::bvh, {mesh.positions.span(), mesh.triangles.span()});
  const double box_area = velum::bounding_volume(velum::VolumeKind::aabb, mesh.positions.span()).area;

  std::vector<velum::PreparedRay> rays;
  int seen = 0;
  for (const velum::Ray& line : lines_through(tree->bounds(), 100000)) {
    velum::CastCounters counters;
    seen += tree->is_blocked(line, {}, counters);
    rays.emplace_back(line, velum::Interval{}, tree->bounds());
  }
  std::printf("%-10s %7s %6s %7s %13s %7s\n", "volume", "planes", "area", "lines", "of these hit", "ns");
  for (const velum::VolumeName& name : velum::volume_names()) {
    if (name.kind == velum::VolumeKind::convex_hull && !velum::has_convex_hull()) continue;
    const velum::BoundingVolume volume = velum::bounding_volume(name.kind, mesh.positions.span());
    int met = 0;
    const std::clock_t start = std::clock();
    for (const velum::PreparedRay& ray : rays) met += !velum::interval_inside(ray, volume).is_empty();
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const auto lines = static_cast<double>(rays.size());
    std::printf("%-10s %7zu %6.3f %6.1f%% %12.1f%% %7.0f\n", name.name, volume.planes.size(),
                volume.area / box_area, 100.0 * met / lines, 100.0 * seen / met, seconds / lines * 1e9);
  }
}
