#include "mesh_octree.hpp"

#include <algorithm>
#include <utility>

namespace velum {
namespace {

/// Boxes that are empty where a vertex is not finite: NaN is left out by include(), infinities stay and are
/// not finite.
std::vector<Aabb> boxes_of(const Mesh& mesh) {
  std::vector<Aabb> boxes(mesh.triangles.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const glm::dvec3 zeros = (a - a) + (b - b) + (c - c);
    if (!(zeros == glm::dvec3(0.0))) continue;
    boxes[i].include(a);
    boxes[i].include(b);
    boxes[i].include(c);
  }
  return boxes;
}

template <typename T>
std::size_t bytes_of(const std::vector<T>& values) {
  return values.capacity() * sizeof(T);
}

}  // namespace

/// Appends clusters one after the other.
class MeshOctree::Writer {
 public:
  Writer(const Mesh& mesh, MeshOctree& out)
      : mesh_(mesh), out_(out), local_(mesh.positions.size()), owner_(mesh.positions.size(), none) {
    out.cluster_of_triangle_.resize(mesh.triangles.size());
  }

  void write(std::span<const std::uint32_t> items) {
    const std::vector<std::uint32_t> triangles = swept(items);
    const auto cluster = static_cast<std::uint32_t>(out_.spans_.size());
    Span span{static_cast<std::uint32_t>(out_.positions_.size()), 0,
              static_cast<std::uint32_t>(out_.triangles_.size()),
              static_cast<std::uint32_t>(triangles.size()), static_cast<std::uint32_t>(out_.windows_.size())};
    for (const std::uint32_t i : triangles) {
      out_.triangles_.push_back(i);
      out_.cluster_of_triangle_[i] = cluster;
      const glm::uvec3& t = mesh_.triangles[i];
      for (int v = 0; v < 3; ++v) {
        const std::uint32_t index = local(t[v], cluster, span);
        out_.indices_.push_back(index);
        out_.corners_[v].push_back(static_cast<std::uint16_t>(index - span.first_position));
      }
    }
    write_windows(span);
    out_.spans_.push_back(span);
    const MeshCluster written = out_.cluster(cluster);
    out_.cones_.push_back(normal_cone(out_.positions_, written.indices));
    const bool is_empty = written.positions.empty();
    out_.tight_boxes_.push_back(is_empty ? OrientedBox{}
                                         : oriented_box(written.positions, out_.cones_.back().axis));
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  void write_windows(const Span& span) {
    for (std::size_t i = 0; i < span.triangle_count; i += window_triangles) {
      const auto from = [&](int v) { return out_.corners_[v].data() + span.first_triangle + i; };
      out_.windows_.push_back(window_of_corners({from(0), from(1), from(2)},
                                                std::min(window_triangles, span.triangle_count - i)));
    }
  }

  /// Triangles in the order in which a plane across the longest axis sweeps over them: neighbours in the list
  /// then have vertices that are neighbours, too.
  std::vector<std::uint32_t> swept(std::span<const std::uint32_t> items) const {
    const auto sum_of = [&](std::uint32_t i) {
      const glm::uvec3& t = mesh_.triangles[i];
      return glm::dvec3(mesh_.positions[t.x]) + glm::dvec3(mesh_.positions[t.y]) +
             glm::dvec3(mesh_.positions[t.z]);
    };
    Aabb reach;
    std::vector<std::uint32_t> order(items.begin(), items.end());
    for (const std::uint32_t i : items) {
      const glm::dvec3 sum = sum_of(i);
      if (!(sum - sum == glm::dvec3(0.0))) return order;  // a vertex is not finite
      reach.include(sum);
    }
    const glm::dvec3 size = reach.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::vector<std::pair<double, std::uint32_t>> along;
    for (const std::uint32_t i : items) along.emplace_back(sum_of(i)[axis], i);
    std::sort(along.begin(), along.end());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = along[i].second;
    return order;
  }

  std::uint32_t local(std::uint32_t vertex, std::uint32_t cluster, Span& span) {
    if (owner_[vertex] != cluster) {
      owner_[vertex] = cluster;
      local_[vertex] = span.first_position + span.position_count++;
      out_.positions_.push_back(mesh_.positions[vertex]);
    }
    return local_[vertex];
  }

  const Mesh& mesh_;
  MeshOctree& out_;
  std::vector<std::uint32_t> local_;  // where a vertex stands in the cluster that owns it now
  std::vector<std::uint32_t> owner_;
};

MeshOctree::MeshOctree(const Mesh& mesh, const MeshOctreeOptions& options) {
  OctreeOptions octree_options;
  octree_options.placement = options.placement;
  octree_options.leaf_size = options.leaf_size;
  octree_ = Octree(boxes_of(mesh), octree_options);
  indices_.reserve(3 * mesh.triangles.size());
  triangles_.reserve(mesh.triangles.size());
  Writer writer(mesh, *this);
  const std::span<const std::uint32_t> items(octree_.items());
  for (const OctreeNode& node : octree_.nodes()) {
    writer.write(items.subspan(node.first, node.own_end - node.first));
  }
  writer.write(octree_.loose());
  for (std::vector<std::uint16_t>& corners : corners_) {
    corners.resize(corners.size() + corners_behind);
    corners.shrink_to_fit();
  }
  positions_.shrink_to_fit();
  parents_.assign(cluster_count(), no_parent);
  for (std::uint32_t i = 0; i < nodes().size(); ++i) {
    const OctreeNode& node = nodes()[i];
    for (std::uint32_t k = 0; k < node.child_count; ++k) parents_[node.first_child + k] = i;
  }
}

MeshCluster MeshOctree::clusters(std::size_t first, std::size_t end) const {
  const Span &from = spans_[first], &last = spans_[end - 1];
  const std::size_t positions = last.first_position + last.position_count - from.first_position;
  const std::size_t triangles = last.first_triangle + last.triangle_count - from.first_triangle;
  return {std::span(positions_).subspan(from.first_position, positions),
          from.first_position,
          std::span(indices_).subspan(3 * std::size_t{from.first_triangle}, 3 * triangles),
          std::span(triangles_).subspan(from.first_triangle, triangles),
          {corners_[0].data() + from.first_triangle, corners_[1].data() + from.first_triangle,
           corners_[2].data() + from.first_triangle},
          windows_.data() + from.first_window};
}

std::size_t MeshOctree::bytes() const {
  return octree_.bytes() + bytes_of(spans_) + bytes_of(cones_) + bytes_of(tight_boxes_) +
         bytes_of(positions_) + bytes_of(indices_) + bytes_of(triangles_) + bytes_of(cluster_of_triangle_) +
         bytes_of(parents_) + bytes_of(corners_[0]) + bytes_of(corners_[1]) + bytes_of(corners_[2]) +
         bytes_of(windows_);
}

}  // namespace velum
