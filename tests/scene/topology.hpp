#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "scene/mesh.hpp"

/// A mesh whose vertices with the same position, bit by bit, are one.
struct Welded {
  std::vector<glm::dvec3> positions;
  std::vector<glm::uvec3> triangles;
};

inline Welded weld(const velum::Mesh& mesh) {
  Welded result;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> known;
  std::vector<std::uint32_t> index;
  for (const glm::vec3& p : mesh.positions) {
    const auto next = static_cast<std::uint32_t>(result.positions.size());
    const auto [entry, is_new] = known.try_emplace(std::bit_cast<std::array<std::uint32_t, 3>>(p), next);
    if (is_new) result.positions.emplace_back(p);
    index.push_back(entry->second);
  }
  for (const glm::uvec3& t : mesh.triangles)
    result.triangles.emplace_back(index[t.x], index[t.y], index[t.z]);
  return result;
}

/// How often each directed edge occurs.
using EdgeCounts = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

inline EdgeCounts directed_edges(const Welded& mesh) {
  EdgeCounts counts;
  for (const glm::uvec3& t : mesh.triangles) {
    ++counts[{t.x, t.y}];
    ++counts[{t.y, t.z}];
    ++counts[{t.z, t.x}];
  }
  return counts;
}

/// Every directed edge once, its opposite once, and no edge from a vertex to itself.
inline bool is_closed(const Welded& mesh) {
  const EdgeCounts counts = directed_edges(mesh);
  for (const auto& [edge, count] : counts) {
    const auto opposite = counts.find({edge.second, edge.first});
    if (count != 1 || edge.first == edge.second || opposite == counts.end()) return false;
  }
  return true;
}

/// Vertices - edges + faces of a closed mesh: 2 for each ball, 0 for a torus.
inline std::int64_t euler_characteristic(const Welded& mesh) {
  return static_cast<std::int64_t>(mesh.positions.size()) -
         static_cast<std::int64_t>(directed_edges(mesh).size() / 2) +
         static_cast<std::int64_t>(mesh.triangles.size());
}

/// The signed volume of each connected part; positive where triangles face outwards.
inline std::vector<double> volumes(const Welded& mesh) {
  std::vector<std::uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const glm::uvec3& t : mesh.triangles) {
    parent[root(t.x)] = root(t.y);
    parent[root(t.y)] = root(t.z);
  }
  std::map<std::uint32_t, double> sums;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
    sums[root(t.x)] += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  std::vector<double> result;
  for (const auto& [part, volume] : sums) result.push_back(volume);
  return result;
}

inline double volume(const velum::Mesh& mesh) {
  double sum = 0.0;
  for (const double part : volumes(weld(mesh))) sum += part;
  return sum;
}
