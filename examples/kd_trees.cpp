// One mesh in kd-trees that are built and walked in different ways: what building, loading and a ray cost, in
// processor time, and how many nodes and triangles a ray meets.
#include <velum/raycast/kd/kd_file.hpp>
#include <velum/raycast/kd/kd_packet.hpp>
#include <velum/velum.hpp>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <glm/geometric.hpp>
#include <vector>

namespace {

struct Way {
  const char* name;
  velum::KdSettings settings;
  bool in_packets = false;
};

double seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The least of three.
template <typename Action>
double least_time(const Action& action) {
  double least = 1e9;
  for (int i = 0; i < 3; ++i) {
    const double start = seconds();
    action();
    least = std::min(least, seconds() - start);
  }
  return least;
}

/// Through a square of pixels, from a point before the mesh.
std::vector<velum::Ray> camera_rays(const velum::Aabb& box, int side) {
  const double size = std::max({box.size().x, box.size().y, box.size().z});
  const glm::dvec3 eye = box.centre() + glm::dvec3(0.3, 0.4, 1.5) * size;
  std::vector<velum::Ray> rays;
  for (int i = 0; i < side * side; ++i) {
    const double u = (i % side + 0.5) / side - 0.5, v = (i / side + 0.5) / side - 0.5;
    rays.push_back({eye, box.centre() + glm::dvec3(u, v, 0.0) * size - eye});
  }
  return rays;
}

}  // namespace

int main(int argc, char** argv) {
  using enum velum::KdWalk;
  constexpr velum::KdCut split = velum::KdCut::split;
  const velum::Scene scene = velum::load_scene(argc > 1 ? argv[1] : "builtin:house");
  const auto largest =
      std::max_element(scene.meshes().begin(), scene.meshes().end(),
                       [](const auto& a, const auto& b) { return a.triangles.size() < b.triangles.size(); });
  const velum::TriangleSet triangles{largest->positions.span(), largest->triangles.span()};
  const Way ways[] = {{"exact", {}},
                      {"exact, recursive", {.walk = recursive}},
                      {"exact, ropes", {.walk = ropes}},
                      {"exact, packets", {}, true},
                      {"16 samples", {.samples = 16}},
                      {"split", {.cut = split}},
                      {"split, 16 samples", {.cut = split, .samples = 16}},
                      {"split, ropes", {.walk = ropes, .cut = split}}};
  std::printf("%u triangles\n%-18s %9s %9s %9s %9s %9s %9s %7s\n", triangles.size(), "tree", "build ms",
              "load ms", "byte/tri", "nodes/ray", "tests/ray", "mailbox", "ns/ray");
  for (const Way& way : ways) {
    std::unique_ptr<velum::KdTree> tree, loaded;
    const double build = least_time([&] { tree = std::make_unique<velum::KdTree>(triangles, way.settings); });
    velum::save_kd_tree("kd_trees.kd", *tree);
    const double load =
        least_time([&] { loaded = velum::load_kd_tree("kd_trees.kd", triangles, way.settings.walk); });
    const std::vector<velum::Ray> rays = camera_rays(tree->bounds(), 200);
    const auto count = static_cast<double>(rays.size());
    velum::CastCounters counters;
    std::vector<velum::RayHit> hits(rays.size());
    const double cast = least_time([&] {
      counters = {};
      if (way.in_packets) return velum::first_hits(*loaded, rays, {}, counters, hits);
      for (const velum::Ray& ray : rays) loaded->first_hit(ray, {}, counters);
    });
    std::printf("%-18s %9.1f %9.1f %9.1f %9.1f %9.2f %9.2f %7.0f\n", way.name, build * 1e3, load * 1e3,
                static_cast<double>(tree->memory()) / triangles.size(),
                static_cast<double>(counters.nodes) / count, static_cast<double>(counters.tests) / count,
                static_cast<double>(counters.mailbox) / count, cast / count * 1e9);
  }
}
