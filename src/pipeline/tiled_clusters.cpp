#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "../visibility/tile_transfer.hpp"
#include "cluster_drawer.hpp"
#include "polygon_culling.hpp"

namespace velum {
namespace {

/// Triangles per group: enough to amortise the sorting, few enough to stay in cache.
constexpr std::size_t group_size = 32768;
/// Level of the pyramid where a tile is one value.
constexpr int tile_level = 6;
static_assert(tile_size == 1 << tile_level);

/// Keeps those of the first `count` that are not hidden. @return how many
/// @param triangle  triangle(i) is number i
/// @param move      move(to, from) is called where one takes another's place
template <typename Triangle, typename Move>
std::size_t seen_of(std::size_t count, const PolygonCulling& culling, HierarchyCounters& counters,
                    const Triangle& triangle, const Move& move) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (culling.is_hidden(triangle(i), counters)) continue;
    if (kept != i) move(kept, i);
    ++kept;
  }
  return kept;
}

}  // namespace

TiledClusters::TiledClusters(const ClusterInput& input, TiledClusterBuffers& buffers)
    : input_(input),
      buffers_(buffers),
      grid_(input.frame.rect),
      transform_(transform_kernel(input.frame.settings.isa)),
      leave_out_empty_(empty_triangles_kernel(input.frame.settings.isa)),
      set_up_(set_up_kernel(input.frame.settings.isa)),
      set_up_small_(set_up_small_kernel(input.frame.settings.isa)),
      raster_(tile_raster(input.frame.settings.isa)) {
  const auto tiles = static_cast<std::size_t>(grid_.count());
  if (buffers.tiles.size() < tiles) buffers.tiles.resize(tiles);
  buffers.states.assign(tiles, TiledClusterBuffers::TileState::untouched);
  buffers.workers.resize(static_cast<std::size_t>(input.frame.executor.threads()));
}

void TiledClusters::draw(const ClusterBatch& batch) {
  if (batch.entries.empty()) return;
  make_groups(batch);
  std::size_t most = 0;
  for (std::size_t i = 0; i < buffers_.used; ++i) most = std::max(most, buffers_.groups[i].triangles);
  for (Worker& worker : buffers_.workers) {
    worker.indices.make_room(3 * most);
    worker.triangles.make_room(most + kept_room);
    worker.packed.make_room(packed_room(3 * most));
  }
  input_.frame.executor.for_each(buffers_.used, [&](std::size_t i, int worker) {
    set_up_group(batch, buffers_.groups[i], buffers_.workers[static_cast<std::size_t>(worker)]);
  });
  for (Worker& worker : buffers_.workers) worker.counts = {};
  input_.frame.executor.for_each(buffers_.states.size(), [&](std::size_t i, int worker) {
    draw_tile(i, buffers_.workers[static_cast<std::size_t>(worker)]);
  });
  Counters& counters = input_.counters;
  for (std::size_t i = 0; i < buffers_.used; ++i) counters += buffers_.groups[i].counters;
  for (const Worker& worker : buffers_.workers) {
    counters.hidden_triangles += worker.counts.hidden_triangles;
    counters.hidden_blocks += worker.counts.hidden_blocks;
    counters.drawn_blocks += worker.counts.drawn_blocks;
  }
}

void TiledClusters::make_groups(const ClusterBatch& batch) {
  buffers_.used = 0;
  const auto count = static_cast<std::uint32_t>(batch.entries.size());
  for (std::uint32_t first = 0, last = 0; first < count; first = last) {
    std::size_t triangles = 0;
    while (last < count && triangles < group_size) {
      const ClusterBatch::Entry& entry = batch.entries[last++];
      const std::uint32_t mesh = input_.frame.scene.instances()[batch.meshes[entry.placed].instance].mesh;
      triangles += input_.octrees.mesh(mesh).triangle_count(entry.cluster);
    }
    if (buffers_.used == buffers_.groups.size()) buffers_.groups.emplace_back();
    TiledClusterBuffers::Group& group = buffers_.groups[buffers_.used++];
    group.first = first;
    group.last = last;
    group.triangles = triangles;
  }
}

void TiledClusters::set_up_group(const ClusterBatch& batch, Group& group, Worker& worker) const {
  group.counters = {};
  ScreenPrimitives& primitives = group.primitives;
  primitives.clear();
  primitives.make_room(group.triangles);
  for (std::uint32_t i = group.first, end = i; i < group.last; i = end) {
    while (end < group.last && batch.entries[end].placed == batch.entries[i].placed) ++end;
    set_up_instance(batch, i, end, group, worker);
  }
  if (input_.tests_polygons && !batch.comes_first) leave_out_hidden(primitives, group.counters.hierarchy);
  group.bins.sort(primitives, grid_);
}

/// Sets up entries first … end-1, all of one instance.
void TiledClusters::set_up_instance(const ClusterBatch& batch, std::uint32_t first, std::uint32_t end,
                                    Group& group, Worker& worker) const {
  const ClusterBatch::PlacedMesh& placed = batch.meshes[batch.entries[first].placed];
  const Scene& scene = input_.frame.scene;
  const Instance& instance = scene.instances()[placed.instance];
  const MeshOctree& octree = input_.octrees.mesh(instance.mesh);
  const bool is_mirrored = is_mirroring(instance.world_from_object);
  worker.kept = 0;
  for (std::uint32_t i = first, next = i; i < end; i = next) {
    for (next = i + 1; next < end; ++next) {
      if (!octree.are_neighbours(batch.entries[next - 1].cluster, batch.entries[next].cluster)) break;
    }
    place_vertices(placed, octree,
                   octree.clusters(batch.entries[i].cluster, batch.entries[next - 1].cluster + 1), group,
                   worker);
    for (std::uint32_t k = i; k < next; ++k) {
      leave_out_empty(octree.cluster(batch.entries[k].cluster), is_mirrored, group, worker);
    }
  }
  SetUpWork work;
  set_up_triangles(
      {scene, input_.frame.settings, grid_, set_up_, set_up_small_},
      {worker.indices.data(), 0, worker.kept, scene.first_primitive(placed.instance), worker.triangles.data(),
       octree.positions().data(), worker.placed.data(), nullptr, worker.clip_from_object, is_mirrored},
      work, group.primitives, worker.scratch, group.counters);
}

void TiledClusters::place_vertices(const ClusterBatch::PlacedMesh& placed, const MeshOctree& octree,
                                   const MeshCluster& cluster, Group& group, Worker& worker) const {
  const RenderSettings& settings = input_.frame.settings;
  if (worker.placed.size() < octree.positions().size()) worker.placed.resize(octree.positions().size());
  worker.clip_from_object = placed.clip_from_object;
  // By whole vectors: what stands behind is placed anew, in the same places, when it is needed.
  const std::size_t behind = octree.positions().size() - cluster.first_position;
  const std::size_t count = std::min((cluster.positions.size() + 7) / 8 * 8, behind);
  transform_({&cluster.positions[0].x, count, glm::value_ptr(worker.clip_from_object), settings.width,
              settings.height, nullptr, nullptr, worker.placed.data() + cluster.first_position, nullptr});
  group.counters.vertices += cluster.positions.size();
}

/// Appends those of the cluster's triangles that may cover a pixel centre to the worker's.
void TiledClusters::leave_out_empty(const MeshCluster& cluster, bool is_mirrored, Group& group,
                                    Worker& worker) const {
  SetUpWork facing{};
  set_culling(facing, input_.frame.settings.cull, is_mirrored);
  worker.kept += leave_out_empty_({worker.placed.data(),
                                   cluster.first_position,
                                   static_cast<std::uint32_t>(cluster.positions.size()),
                                   cluster.indices.data(),
                                   {cluster.corners[0], cluster.corners[1], cluster.corners[2]},
                                   cluster.windows,
                                   cluster.triangles.data(),
                                   static_cast<std::uint32_t>(cluster.triangles.size()),
                                   facing.is_back_positive,
                                   facing.cull_positive,
                                   facing.cull_negative,
                                   worker.indices.data() + 3 * static_cast<std::size_t>(worker.kept),
                                   worker.triangles.data() + worker.kept,
                                   worker.packed.data()},
                                  group.counters);
}

void TiledClusters::leave_out_hidden(ScreenPrimitives& primitives, HierarchyCounters& counters) const {
  const PolygonCulling culling(input_.pyramid, grid_.target, DepthFormat::reversed);
  ScreenPrimitives& p = primitives;
  p.large_count = seen_of(
      p.large_count, culling, counters, [&](std::size_t i) -> const RasterTriangle& { return p.large[i]; },
      [&](std::size_t to, std::size_t from) { p.large[to] = p.large[from]; });
  // All of the small ones are set up.
  p.small_count = seen_of(
      p.small_count, culling, counters,
      [&](std::size_t i) -> const SmallTriangle& { return p.small[p.small_refs[i] & ~ready_small]; },
      [&](std::size_t to, std::size_t from) {
        p.small_refs[to] = p.small_refs[from];
        p.small_bounds[to] = p.small_bounds[from];
      });
}

void TiledClusters::draw_tile(std::size_t index, Worker& worker) const {
  const int tile = static_cast<int>(index), left = grid_.left(tile), top = grid_.top(tile);
  TileBuffer& buffer = buffers_.tiles[index];
  TiledClusterBuffers::TileState& state = buffers_.states[index];
  for (std::size_t i = 0; i < buffers_.used; ++i) {
    const TilePrimitives primitives = buffers_.groups[i].bins.of_tile(tile);
    if (primitives.is_empty()) continue;
    if (state == TiledClusterBuffers::TileState::untouched) clear_tile(input_.frame.rect, left, top, buffer);
    state = TiledClusterBuffers::TileState::changed;
    velum::draw_tile(raster_, {&primitives, 1}, left, top, worker.order, buffer, worker.counts);
  }
}

void TiledClusters::publish_tile(std::size_t index, int last_level) const {
  TiledClusterBuffers::TileState& state = buffers_.states[index];
  if (state != TiledClusterBuffers::TileState::changed) return;
  state = TiledClusterBuffers::TileState::published;
  const Rect& rect = input_.frame.rect;
  const int tile = static_cast<int>(index), left = grid_.left(tile), top = grid_.top(tile);
  store_tile(buffers_.tiles[index], rect, left, top, input_.buffer);
  input_.pyramid.update(
      intersect({left - rect.left, top - rect.top, tile_size, tile_size}, {0, 0, rect.width, rect.height}), 1,
      last_level);
}

void TiledClusters::publish(bool is_last) {
  ++input_.counters.hierarchy.batches;
  const int last = is_last ? 0 : std::min(tile_level, input_.pyramid.levels() - 1);
  input_.frame.executor.for_each(buffers_.states.size(), [&](std::size_t i, int) { publish_tile(i, last); });
  if (is_last) return;
  const Rect& rect = input_.frame.rect;
  input_.pyramid.update({0, 0, rect.width, rect.height}, last + 1, input_.pyramid.levels() - 1);
}

}  // namespace velum
