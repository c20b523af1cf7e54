#include "hierarchical_stage.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "../visibility/cone_culling.hpp"
#include "../visibility/depth_format.hpp"

namespace velum {
namespace {

/// Triangles drawn before the pyramid is brought up to date, at least and at most; and the batches that a
/// scene should make if that allows.
constexpr std::uint64_t smallest_batch = 1 << 15;
constexpr std::uint64_t largest_batch = 1 << 18;
constexpr std::uint64_t batches_of_scene = 32;
/// Triangles drawn in one go at most: bounds the memory.
constexpr std::uint64_t remembered_batch = 1 << 20;
/// The pyramid is brought up to date when so much of what was remembered is drawn anew.
constexpr std::uint64_t remembered_per_batch = 2;

std::uint64_t batch_size_for(const Scene& scene, const RenderSettings& settings) {
  if (settings.hierarchy.batch_size != 0) return settings.hierarchy.batch_size;
  return std::clamp<std::uint64_t>(scene.primitive_count() / batches_of_scene, smallest_batch, largest_batch);
}

/// A mesh as this frame's camera sees it in one place.
struct PlacedOctree {
  std::uint32_t instance;
  const MeshOctree& octree;
  BoxProjection projection;
  ConeCulling cones;
  double culled_sign;  ///< of the determinants of triangles that are culled; 0: none are
  double away_sign;    ///< of those that face away
  std::uint32_t in_batch = none;

  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  PlacedOctree(const TileStageInput& input, const SceneOctrees& octrees, std::uint32_t index)
      : instance(index),
        octree(octrees.mesh(input.scene.instances()[index].mesh)),
        projection(input.viewing.clip_from_object(input.scene.instances()[index].world_from_object),
                   {input.settings.width, input.settings.height},
                   octree.nodes().empty() ? Aabb{} : octree.nodes().front().box),
        cones(projection) {
    away_sign = is_mirroring(input.scene.instances()[index].world_from_object) ? 1.0 : -1.0;
    culled_sign = input.settings.cull == Cull::none   ? 0.0
                  : input.settings.cull == Cull::back ? away_sign
                                                      : -away_sign;
  }
  PlacedOctree(const PlacedOctree&) = delete;
};

class HierarchicalStage {
  using Node = HierarchicalBuffers::Node;
  /// The nodes of one octree.
  struct Nodes {
    const std::vector<OctreeNode>& all;
    const MeshOctree* mesh = nullptr;      ///< whose they are; none: of the scene
    const ClusterState* states = nullptr;  ///< per cluster, where some are drawn already
  };

 public:
  HierarchicalStage(const TileStageInput& input, HierarchicalBuffers& buffers, ClusterDrawer& drawer,
                    Counters& counters, std::vector<NodeRecord>* records)
      : input_(input),
        settings_(input.settings.hierarchy),
        buffers_(buffers),
        octrees_(buffers.octrees),
        drawer_(drawer),
        counters_(counters),
        records_(records),
        batch_size_(batch_size_for(input.scene, input.settings)) {}

  void draw() {
    buffers_.batch.clear();
    buffers_.postponed.clear();
    if (settings_.use == HierarchyUse::polygons) return draw_everything();
    draw_remembered();
    draw_placeless();
    walk_scene();
    // Few triangles hide little that was not hidden before.
    const std::uint64_t few = std::max(smallest_batch, remembered_ / remembered_per_batch);
    if (!buffers_.remembers || unpublished_ + buffers_.batch.triangles >= few) flush();
    draw_postponed();
    flush(true);
  }

 private:
  // Batches.

  void add(PlacedOctree& placed, std::uint32_t cluster) {
    const auto triangles = placed.octree.triangle_count(cluster);
    if (triangles == 0) return;
    ClusterBatch& batch = buffers_.batch;
    if (placed.in_batch == PlacedOctree::none) {
      placed.in_batch = static_cast<std::uint32_t>(batch.meshes.size());
      batch.meshes.push_back({placed.instance, placed.projection.clip_from_object()});
    }
    batch.entries.push_back({placed.in_batch, cluster});
    batch.triangles += triangles;
    ++counters_.hierarchy.clusters_drawn;
    record(placed.instance, cluster, NodeFate::drawn);
  }

  void draw_batch() {
    // Those that stand side by side in memory are then drawn as one. What was remembered is in this order.
    if (!buffers_.batch.comes_first) sort_batch();
    drawer_.draw(buffers_.batch);
    drawn_ += buffers_.batch.triangles;
    unpublished_ += buffers_.batch.triangles;
    buffers_.batch.clear();
    input_.progress(std::min(1.0, static_cast<double>(drawn_) / input_.scene.primitive_count()));
  }

  void sort_batch() {
    std::sort(buffers_.batch.entries.begin(), buffers_.batch.entries.end(), [](const auto& a, const auto& b) {
      return a.placed != b.placed ? a.placed < b.placed : a.cluster < b.cluster;
    });
  }

  void flush(bool is_last = false) {
    if (buffers_.batch.entries.empty() && unpublished_ == 0) return;
    draw_batch();
    drawer_.publish(is_last);
    unpublished_ = 0;
  }

  /// Draws what waits if it is much, and brings the pyramid up to date if that is much beside what was
  /// remembered: after that it hardly changes.
  void flush_if_full(PlacedOctree& placed) {
    const std::uint64_t waiting = buffers_.batch.triangles;
    if (waiting < batch_size_) return;
    if (unpublished_ + waiting >= remembered_ / remembered_per_batch) {
      flush();
    } else if (waiting >= std::min(remembered_batch, remembered_)) {
      draw_batch();
    } else {
      return;
    }
    placed.in_batch = PlacedOctree::none;
  }

  void record(std::uint32_t instance, std::uint32_t node, NodeFate fate) {
    if (records_ != nullptr) records_->push_back({instance, node, fate});
  }

  // Tests.

  /// The node's bounds; none if it is beyond the view volume or the part of the picture that is wanted.
  std::optional<Node> look_at(const BoxProjection& projection, const Nodes& nodes, std::uint32_t index,
                              std::uint32_t instance) {
    ++counters_.hierarchy.nodes_visited;
    // A leaf of a mesh has a box that lies along its surface.
    const OctreeNode& node = nodes.all[index];
    const bool has_tight_box = nodes.mesh != nullptr && node.child_count == 0;
    const Node seen{index, false,
                    has_tight_box ? projection(nodes.mesh->tight_box(index)) : projection(node.box)};
    const bool is_outside = seen.bounds.is_outside || intersect(seen.bounds.pixels, input_.rect).is_empty();
    if (!is_outside || !settings_.culls_frustum) return seen;
    ++counters_.hierarchy.nodes_outside;
    record(instance, index, NodeFate::outside);
    return {};
  }

  bool is_hidden(const Node& node, std::uint32_t instance) {
    if (!settings_.culls_pyramid || node.is_above_seen || node.bounds.is_outside) return false;
    Rect pixels = node.bounds.pixels;
    pixels.left -= input_.rect.left;
    pixels.top -= input_.rect.top;
    const float bound = stored_depth(input_.settings.depth_format, node.bounds.nearest);
    const PyramidAnswer answer = buffers_.pyramid.is_hidden(pixels, bound);
    if (!answer.is_hidden) return false;
    ++counters_.hierarchy.nodes_hidden;
    ++counters_.hierarchy.nodes_hidden_at[answer.level];
    record(instance, node.index, NodeFate::hidden);
    return true;
  }

  bool faces_away(const PlacedOctree& placed, std::uint32_t node) {
    if (!settings_.culls_cones || placed.culled_sign == 0.0) return false;
    const Aabb& box = placed.octree.nodes()[node].box;
    if (!placed.cones.all_have_sign(placed.octree.cone(node), box, placed.culled_sign)) return false;
    ++counters_.hierarchy.clusters_away;
    record(placed.instance, node, NodeFate::facing_away);
    return true;
  }

  // Traversal.

  /// Pushes a node's children that are not outside, the nearest last.
  void push_children(const BoxProjection& projection, const Nodes& nodes, const OctreeNode& parent,
                     std::uint32_t instance, std::vector<Node>& stack) {
    std::array<Node, 8> children;
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < parent.child_count; ++i) {
      const std::uint32_t index = parent.first_child + i;
      const ClusterState state = nodes.states == nullptr ? ClusterState::unseen : nodes.states[index];
      if (state == ClusterState::seen && nodes.all[index].child_count == 0) continue;
      if (state == ClusterState::above_seen) {
        children[count++] = {index, true, {}};
        continue;
      }
      if (const auto child = look_at(projection, nodes, index, instance)) children[count++] = *child;
    }
    // By insertion: they are few, and equal ones keep their order.
    for (std::size_t i = 1; i < count; ++i) {
      for (std::size_t k = i; k > 0 && children[k].bounds.nearest < children[k - 1].bounds.nearest; --k) {
        std::swap(children[k], children[k - 1]);
      }
    }
    stack.insert(stack.end(), children.begin(), children.begin() + static_cast<std::ptrdiff_t>(count));
  }

  void walk_scene() {
    const std::vector<OctreeNode>& nodes = octrees_.instances().nodes();
    if (nodes.empty()) return;
    const BoxProjection projection(input_.viewing, {input_.settings.width, input_.settings.height},
                                   octrees_.reach());
    std::vector<Node>& stack = buffers_.scene_stack;
    stack.clear();
    if (const auto root = look_at(projection, {nodes}, 0, NodeRecord::of_scene)) stack.push_back(*root);
    while (!stack.empty()) {
      const Node node = stack.back();
      stack.pop_back();
      if (is_hidden(node, NodeRecord::of_scene)) continue;
      const OctreeNode& place = nodes[node.index];
      push_children(projection, {nodes}, place, NodeRecord::of_scene, stack);
      for (std::uint32_t i = place.first; i < place.own_end; ++i) {
        walk_mesh(octrees_.instances().items()[i]);
      }
    }
  }

  void walk_mesh(std::uint32_t instance) {
    PlacedOctree placed(input_, octrees_, instance);
    ++counters_.instances;
    const ClusterState* const states =
        buffers_.remembers ? &buffers_.states[octrees_.first_cluster(instance)] : nullptr;
    const Nodes nodes{placed.octree.nodes(), &placed.octree, states};
    std::vector<Node>& stack = buffers_.mesh_stack;
    stack.clear();
    if (const auto root = look_at(placed.projection, nodes, 0, instance)) stack.push_back(*root);
    while (!stack.empty()) {
      const Node node = stack.back();
      stack.pop_back();
      if (is_hidden(node, instance)) continue;
      visit_cluster(placed, node);
      push_children(placed.projection, nodes, nodes.all[node.index], instance, stack);
    }
  }

  /// Draws a node's own triangles, unless they are drawn, or not to be drawn, or not yet.
  void visit_cluster(PlacedOctree& placed, const Node& node) {
    if (placed.octree.is_empty(node.index) || is_drawn(placed, node.index)) return;
    if (faces_away(placed, node.index)) return;
    const Aabb& box = placed.octree.nodes()[node.index].box;
    if (settings_.culls_pyramid &&
        placed.cones.has_sign(placed.octree.cone(node.index), box, placed.away_sign)) {
      buffers_.postponed.push_back({placed.instance, node});
      return;
    }
    add(placed, node.index);
    flush_if_full(placed);
  }

  bool is_drawn(const PlacedOctree& placed, std::uint32_t cluster) const {
    return buffers_.remembers &&
           buffers_.states[octrees_.first_cluster(placed.instance) + cluster] == ClusterState::seen;
  }

  void draw_postponed() {
    std::optional<PlacedOctree> placed;
    for (const HierarchicalBuffers::Postponed& postponed : buffers_.postponed) {
      if (is_hidden(postponed.node, postponed.instance)) continue;
      if (!placed || placed->instance != postponed.instance) {
        placed.emplace(input_, octrees_, postponed.instance);
      }
      add(*placed, postponed.node.index);
      flush_if_full(*placed);
    }
  }

  /// Clusters seen in the frame before. Those of an instance that is outside now are forgotten.
  void draw_remembered() {
    if (!buffers_.remembers) return;
    buffers_.batch.comes_first = true;
    for (std::uint32_t i = 0; i < input_.scene.instances().size(); ++i) {
      const auto first = buffers_.states.begin() + static_cast<std::ptrdiff_t>(octrees_.first_cluster(i));
      const auto end = buffers_.states.begin() + static_cast<std::ptrdiff_t>(octrees_.first_cluster(i + 1));
      auto next = std::find(first, end, ClusterState::seen);
      if (next == end) continue;
      PlacedOctree placed(input_, octrees_, i);
      if (!look_at(placed.projection, {placed.octree.nodes(), &placed.octree}, 0, i)) {
        std::fill(first, end, ClusterState::unseen);
        continue;
      }
      for (; next != end; next = std::find(next + 1, end, ClusterState::seen)) {
        const bool is_drawn = draw_again(placed, static_cast<std::uint32_t>(next - first));
        *next = is_drawn ? ClusterState::seen : ClusterState::unseen;
        if (buffers_.batch.triangles < remembered_batch) continue;
        draw_batch();
        placed.in_batch = PlacedOctree::none;
        buffers_.batch.comes_first = true;
      }
    }
    flush();
    if (settings_.batch_size == 0) remembered_ = drawn_;
  }

  bool draw_again(PlacedOctree& placed, std::uint32_t cluster) {
    if (faces_away(placed, cluster)) return false;
    ++counters_.hierarchy.clusters_remembered;
    add(placed, cluster);
    return true;
  }

  /// Triangles without a place in space, and instances whose box is not finite: nothing can be said of them.
  void draw_placeless() {
    for (std::uint32_t i = 0; i < input_.scene.instances().size(); ++i) {
      const MeshOctree& octree = octrees_.mesh(input_.scene.instances()[i].mesh);
      const std::size_t last = octree.cluster_count() - 1;
      if (octree.is_empty(last)) continue;
      PlacedOctree placed(input_, octrees_, i);
      add(placed, static_cast<std::uint32_t>(last));
      flush_if_full(placed);
    }
    for (const std::uint32_t i : octrees_.instances().loose()) {
      if (!octrees_.mesh(input_.scene.instances()[i].mesh).nodes().empty()) draw_instance(i, false);
    }
  }

  void draw_instance(std::uint32_t instance, bool with_placeless) {
    PlacedOctree placed(input_, octrees_, instance);
    ++counters_.instances;
    const std::size_t count = placed.octree.cluster_count() - (with_placeless ? 0 : 1);
    for (std::uint32_t i = 0; i < count; ++i) {
      if (is_drawn(placed, i)) continue;
      add(placed, i);
      flush_if_full(placed);
    }
  }

  void draw_everything() {
    buffers_.remembers = false;
    for (std::uint32_t i = 0; i < input_.scene.instances().size(); ++i) draw_instance(i, true);
    flush();
  }

  const TileStageInput& input_;
  const HierarchySettings& settings_;
  HierarchicalBuffers& buffers_;
  const SceneOctrees& octrees_;
  ClusterDrawer& drawer_;
  Counters& counters_;
  std::vector<NodeRecord>* records_;
  const std::uint64_t batch_size_;
  std::uint64_t drawn_ = 0;
  std::uint64_t unpublished_ = 0;  ///< of them those that the pyramid does not know
  std::uint64_t remembered_ = 0;   ///< those that were drawn first
};

}  // namespace

void draw_hierarchically(const TileStageInput& input, bool uses_tiles, HierarchicalBuffers& buffers,
                         VisibilityBuffer& buffer, Counters& counters, std::vector<NodeRecord>* records) {
  const HierarchySettings& settings = input.settings.hierarchy;
  const bool is_new = buffers.octrees.update(input.scene, settings);
  buffers.remembers = buffers.remembers && !is_new && settings.remembers_visible;
  buffers.pyramid.begin(buffer.reversed_depth.view());
  const std::uint64_t before = counters.triangles;
  const ClusterInput cluster_input{input,  buffers.octrees, buffers.pyramid,
                                   buffer, counters,        settings.use != HierarchyUse::octree};
  if (uses_tiles) {
    TiledClusters drawer(cluster_input, buffers.tiles);
    HierarchicalStage(input, buffers, drawer, counters, records).draw();
  } else {
    PlainClusters drawer(cluster_input);
    HierarchicalStage(input, buffers, drawer, counters, records).draw();
  }
  std::uint64_t triangles = 0;
  for (const Instance& instance : input.scene.instances()) {
    triangles += input.scene.meshes()[instance.mesh].triangles.size();
  }
  counters.hierarchy.octree_bytes = buffers.octrees.bytes();
  counters.hierarchy.triangles_left_out += triangles - (counters.triangles - before);
  buffers.remembers = settings.remembers_visible && settings.use != HierarchyUse::polygons;
  if (buffers.remembers) mark_visible_clusters(input.scene, buffers.octrees, buffer, buffers.states);
}

}  // namespace velum
