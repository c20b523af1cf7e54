#include "mesh_facts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace velum_app {
namespace {

using velum::Mesh;

constexpr std::uint32_t nowhere = 0xFFFFFFFFu;

/// For every vertex the number of its position; equal positions have equal numbers, and those that are not
/// finite `nowhere`.
std::vector<std::uint32_t> weld(const Mesh& mesh, MeshFacts& facts) {
  std::map<std::array<float, 3>, std::uint32_t> number_of;
  std::vector<std::uint32_t> numbers;
  numbers.reserve(mesh.positions.size());
  for (const glm::vec3& p : mesh.positions) {
    const bool finite = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    if (!finite) {
      ++facts.not_finite;
      numbers.push_back(nowhere);
      continue;
    }
    const auto next = static_cast<std::uint32_t>(number_of.size());
    numbers.push_back(number_of.try_emplace({p.x, p.y, p.z}, next).first->second);
  }
  facts.welded_vertices = number_of.size();
  return numbers;
}

/// An edge between welded vertices, and whether a triangle runs along it from the smaller to the larger.
struct Edge {
  std::uint32_t low;
  std::uint32_t high;
  bool upwards;
  auto key() const { return std::pair(low, high); }
};

std::vector<Edge> sorted_edges(const Mesh& mesh, MeshFacts& facts) {
  const std::vector<std::uint32_t> welded = weld(mesh, facts);
  std::vector<Edge> edges;
  edges.reserve(mesh.triangles.size() * 3);
  for (const glm::uvec3& t : mesh.triangles) {
    const std::array<std::uint32_t, 3> v{welded[t.x], welded[t.y], welded[t.z]};
    if (std::find(v.begin(), v.end(), nowhere) != v.end()) {
      ++facts.skipped;
      continue;
    }
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
      ++facts.zero_area;
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = v[i];
      const std::uint32_t to = v[(i + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), from < to});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.key() < b.key(); });
  return edges;
}

}  // namespace

MeshFacts facts_of(const Mesh& mesh) {
  MeshFacts facts;
  const std::vector<Edge> edges = sorted_edges(mesh, facts);
  for (std::size_t first = 0; first < edges.size();) {
    std::size_t end = first;
    std::size_t upwards = 0;
    for (; end < edges.size() && edges[end].key() == edges[first].key(); ++end) upwards += edges[end].upwards;
    const std::size_t uses = end - first;
    ++facts.edges;
    if (uses == 1) ++facts.boundary_edges;
    if (uses > 2 || (uses == 2 && upwards != 1)) ++facts.irregular_edges;
    first = end;
  }
  return facts;
}

}  // namespace velum_app
