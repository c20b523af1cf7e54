#include "tile_stage.hpp"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "../visibility/tile_transfer.hpp"

namespace velum {
namespace {

/// Primitives per batch: enough to amortise the sorting, few enough to stay in cache.
constexpr std::uint32_t batch_size = 8192;
/// Primitives per round: bounds the memory for those that wait to be drawn.
constexpr std::uint64_t round_size = std::uint64_t{1} << 19;
/// Vertices per round, beyond which no further instance joins it: 41 bytes each.
constexpr std::uint64_t round_vertices = std::uint64_t{1} << 21;
/// Batches of a round times tiles: each batch has a table of the tiles, 4 bytes for each.
constexpr std::uint64_t round_table = std::uint64_t{1} << 23;
/// Batches times tiles of a frame: beyond that looking into the tables costs more than drawing plainly.
constexpr std::uint64_t frame_table = std::uint64_t{1} << 26;
/// Vertices transformed in one go.
constexpr std::size_t vertex_chunk = 8192;

class TileStage {
 public:
  TileStage(const TileStageInput& input, TileStageBuffers& buffers, VisibilityBuffer& buffer,
            Counters& counters)
      : input_(input), buffers_(buffers), buffer_(buffer), counters_(counters), grid_(input.rect) {
    const auto workers = static_cast<std::size_t>(input.executor.threads());
    buffers.screen_triangles.resize(workers);
    buffers.tiles.resize(workers);
    buffers.counts.assign(workers, {});
    buffers.used = 0;
  }

  void draw() {
    for (std::uint32_t i = 0; i < input_.scene.instances().size(); ++i) add_instance(i);
    draw_round();
    for (const TileCounts& counts : buffers_.counts) {
      counters_.hidden_triangles += counts.hidden_triangles;
      counters_.hidden_blocks += counts.hidden_blocks;
      counters_.drawn_blocks += counts.drawn_blocks;
    }
  }

 private:
  /// Puts an instance's primitives into batches; a full round is drawn.
  void add_instance(std::uint32_t instance) {
    const Mesh& mesh = input_.scene.meshes()[input_.scene.instances()[instance].mesh];
    ++counters_.instances;
    counters_.vertices += mesh.positions.size();
    const std::uint64_t primitives = mesh.triangles.size() + mesh.segments.size() + mesh.points.size();
    if (primitives == 0) return;
    const std::uint64_t vertices_then = vertices_in_round_ + mesh.positions.size();
    if (waiting_ + primitives > round_size || vertices_then > round_vertices) draw_round();
    if (buffers_.used == 0) {
      instances_in_round_ = 0;
      vertices_in_round_ = 0;
    }
    vertices_in_round_ += mesh.positions.size();
    const std::uint32_t vertices = instances_in_round_++;
    if (buffers_.vertices.size() < instances_in_round_) buffers_.vertices.resize(instances_in_round_);
    transform(instance, mesh.positions.span(), buffers_.vertices[vertices]);
    add_batches(instance, vertices, PrimitiveKind::triangle, mesh.triangles.size());
    add_batches(instance, vertices, PrimitiveKind::segment, mesh.segments.size());
    add_batches(instance, vertices, PrimitiveKind::point, mesh.points.size());
  }

  void add_batches(std::uint32_t instance, std::uint32_t vertices, PrimitiveKind kind, std::size_t count) {
    const auto end = static_cast<std::uint32_t>(count);
    for (std::uint32_t first = 0, last = 0; first < end; first = last) {
      last = first + std::min(batch_size, end - first);
      if (buffers_.used == buffers_.batches.size()) buffers_.batches.emplace_back();
      PrimitiveBatch& batch = buffers_.batches[buffers_.used++];
      batch.instance = instance;
      batch.kind = kind;
      batch.vertices = vertices;
      batch.first = first;
      batch.last = last;
      waiting_ += last - first;
      // An instance of more than a round keeps its vertices for the next.
      const std::uint64_t table = (buffers_.used + 1) * static_cast<std::uint64_t>(grid_.count() + 1);
      if (waiting_ >= round_size || table > round_table) draw_round();
    }
  }

  void transform(std::uint32_t instance, std::span<const glm::vec3> positions, PlacedVertices& out) {
    const glm::dmat4 clip_from_object =
        input_.viewing.clip_from_object(input_.scene.instances()[instance].world_from_object);
    out.resize(positions.size());
    input_.executor.for_each((positions.size() + vertex_chunk - 1) / vertex_chunk, [&](std::size_t i, int) {
      const std::size_t first = i * vertex_chunk;
      transform_({&positions[first].x, std::min(vertex_chunk, positions.size() - first),
                  glm::value_ptr(clip_from_object), input_.settings.width, input_.settings.height,
                  &out.clip.positions[first].x, &out.clip.outcodes[first], &out.placed[first]});
    });
    if (input_.sample != pixel_centre) move_vertices(out.placed);
  }

  /// To what is seen at the sample, see sample_positions.hpp.
  void move_vertices(std::vector<PlacedVertex>& placed) const {
    for (PlacedVertex& vertex : placed) {
      if (vertex.x == not_snapped) continue;
      vertex = {vertex.x - input_.sample.x, vertex.y - input_.sample.y};
    }
  }

  void draw_round() {
    if (buffers_.used == 0) return;
    const BatchInput batch_input{input_.scene, input_.settings, grid_, set_up_, input_.sample};
    input_.executor.for_each(buffers_.used, [&](std::size_t i, int worker) {
      PrimitiveBatch& batch = buffers_.batches[i];
      set_up_batch(batch_input, buffers_.vertices[batch.vertices], batch,
                   buffers_.screen_triangles[static_cast<std::size_t>(worker)]);
    });
    input_.executor.for_each(static_cast<std::size_t>(grid_.count()), [&](std::size_t i, int worker) {
      draw_tile(static_cast<int>(i), static_cast<std::size_t>(worker));
    });
    for (std::size_t i = 0; i < buffers_.used; ++i) counters_ += buffers_.batches[i].counters;
    drawn_ += waiting_;
    waiting_ = 0;
    buffers_.used = 0;
    input_.progress(static_cast<double>(drawn_) / input_.scene.primitive_count());
  }

  void draw_tile(int index, std::size_t worker) const {
    const int left = grid_.left(index), top = grid_.top(index);
    TileBuffer& tile = buffers_.tiles[worker];
    bool is_loaded = false;
    for (std::size_t i = 0; i < buffers_.used; ++i) {
      const TileBins& bins = buffers_.batches[i].bins;
      const auto entries = bins.of_tile(index);
      if (entries.empty()) continue;
      if (!is_loaded) load(left, top, tile);
      is_loaded = true;
      draw_({bins.triangles.data(), entries.data(), entries.size()}, left, top, tile,
            buffers_.counts[worker]);
    }
    if (is_loaded) store_tile(tile, input_.rect, left, top, buffer_);
  }

  void load(int left, int top, TileBuffer& tile) const {
    if (drawn_ == 0) {
      clear_tile(input_.rect, left, top, tile);
    } else {
      load_tile(buffer_, input_.rect, left, top, tile);
    }
  }

  const TileStageInput& input_;
  TileStageBuffers& buffers_;
  VisibilityBuffer& buffer_;
  Counters& counters_;
  const TileGrid grid_;
  const TransformVertices transform_ = transform_kernel(input_.settings.isa);
  const SetUpTriangles set_up_ = set_up_kernel(input_.settings.isa);
  const RasterizeTile draw_ = tile_raster(input_.settings.isa);
  std::uint32_t instances_in_round_ = 0;
  std::uint64_t vertices_in_round_ = 0;
  std::uint64_t waiting_ = 0;  ///< primitives in batches
  std::uint64_t drawn_ = 0;    ///< primitives of earlier rounds
};

}  // namespace

bool is_worth_tiles(const Scene& scene, const Rect& rect) {
  const auto tiles = static_cast<std::uint64_t>(TileGrid(rect).count());
  return scene.instances().size() * tiles <= frame_table;
}

void draw_in_tiles(const TileStageInput& input, TileStageBuffers& buffers, VisibilityBuffer& buffer,
                   Counters& counters) {
  TileStage(input, buffers, buffer, counters).draw();
}

}  // namespace velum
