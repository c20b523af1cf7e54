#include "tile_stage.hpp"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "../visibility/tile_transfer.hpp"
#include "crop_rejection.hpp"

namespace velum {
namespace {

/// Primitives per batch: enough to amortise the sorting, few enough to stay in cache. A batch has a table of
/// the tiles, so there are more in it where tiles are many; and each tile asks each batch, so there are more
/// where primitives are many.
constexpr std::uint32_t smallest_batch = 8192;
constexpr std::uint32_t largest_batch = 1 << 15;
constexpr std::uint32_t tiles_per_primitive = 4;
constexpr std::uint32_t most_batches = 64;
/// Primitives set up in one go, on all threads.
constexpr std::uint64_t wave_size = std::uint64_t{1} << 18;
/// Vertices beyond which what waits is drawn before the next instance joins: they are kept until then.
constexpr std::uint64_t round_vertices = std::uint64_t{1} << 21;
/// What an instance takes beside its vertices, counted in vertices.
constexpr std::uint64_t vertices_per_instance = 32;
constexpr std::uint64_t bytes_per_vertex = sizeof(PlacedVertex) + sizeof(float);
/// What is set up waits to be drawn until it takes as many bytes, or as many batches: tiles are loaded and
/// stored each time.
constexpr std::uint64_t round_bytes = std::uint64_t{1} << 25;
constexpr std::size_t round_batches = 512;
/// Vertices transformed in one go.
constexpr std::size_t vertex_chunk = 8192;

/// The most vertices that wait at a time.
std::uint64_t vertices_of_round(const Scene& scene) {
  std::uint64_t all = 0, most = round_vertices;
  for (const Instance& instance : scene.instances()) {
    const std::uint64_t vertices = scene.meshes()[instance.mesh].positions.size();
    all += vertices;
    most = std::max(most, vertices);  // a mesh of more waits by itself
  }
  return std::min(all, most);
}

class TileStage {
 public:
  TileStage(const TileStageInput& input, TileStageBuffers& buffers, VisibilityBuffer& buffer,
            Counters& counters)
      : input_(input), buffers_(buffers), buffer_(buffer), counters_(counters), grid_(input.rect) {
    buffers.workers.resize(static_cast<std::size_t>(input.executor.threads()));
    for (TileStageBuffers::Worker& worker : buffers.workers) worker.counts = {};
    buffers.used = 0;
    const std::uint64_t vertices = vertices_of_round(input.scene);
    buffers.placed.make_room(vertices);
    buffers.nearness.make_room(vertices);
    buffer.reshape(input.rect.width, input.rect.height);
  }

  void draw() {
    for (std::uint32_t i = 0; i < input_.scene.instances().size(); ++i) add_instance(i);
    set_up_wave();
    draw_round(true);
    even_out_memory();
    for (const TileStageBuffers::Worker& worker : buffers_.workers) {
      counters_.hidden_triangles += worker.counts.hidden_triangles;
      counters_.hidden_blocks += worker.counts.hidden_blocks;
      counters_.drawn_blocks += worker.counts.drawn_blocks;
    }
  }

 private:
  /// Which worker takes which batch is left to chance: each gets the memory of all others, so that the next
  /// frame finds enough.
  void even_out_memory() {
    TileStageBuffers::Worker& all = buffers_.workers.front();
    const auto grow = [](TileStageBuffers::Worker& worker, const TileStageBuffers::Worker& other) {
      worker.scratch.make_room_like(other.scratch);
      worker.work.make_room(other.work.room());
      worker.order.make_room_like(other.order);
    };
    for (const TileStageBuffers::Worker& worker : buffers_.workers) grow(all, worker);
    for (TileStageBuffers::Worker& worker : buffers_.workers) grow(worker, all);
  }

  /// Puts an instance's primitives into batches; a full wave is set up.
  void add_instance(std::uint32_t instance) {
    const Mesh& mesh = input_.scene.meshes()[input_.scene.instances()[instance].mesh];
    if (is_beside(input_.scene, instance, clip_from_object_of(instance), input_.settings, input_.within)) {
      ++counters_.instances_beside;
      return;
    }
    ++counters_.instances;
    counters_.vertices += mesh.positions.size();
    const std::uint64_t primitives = mesh.triangles.size() + mesh.segments.size() + mesh.points.size();
    if (primitives == 0) return;
    if (waiting_ + primitives > wave_size) set_up_wave();
    const std::uint64_t vertices_here = mesh.positions.size() + vertices_per_instance;
    if (vertices_waiting_ + vertices_here > round_vertices) {
      set_up_wave();
      draw_round(false);
    }
    if (buffers_.used == 0) {
      instances_waiting_ = 0;
      vertices_waiting_ = 0;
      vertices_placed_ = 0;
    }
    vertices_waiting_ += vertices_here;
    const std::uint32_t vertices = instances_waiting_++;
    if (buffers_.vertices.size() < instances_waiting_) buffers_.vertices.emplace_back();
    transform(instance, mesh, buffers_.vertices[vertices]);
    add_runs({instance, PrimitiveKind::triangle, vertices}, mesh.triangles.size());
    add_runs({instance, PrimitiveKind::segment, vertices}, mesh.segments.size());
    add_runs({instance, PrimitiveKind::point, vertices}, mesh.points.size());
  }

  /// Adds primitives 0 … count-1 of the run's kind.
  void add_runs(PrimitiveRun run, std::size_t count) {
    while (run.last < count) {
      if (waiting_ >= wave_size) set_up_wave();
      PrimitiveBatch& batch = open_batch();
      run.first = run.last;
      run.last +=
          static_cast<std::uint32_t>(std::min<std::size_t>(batch_size_ - batch.count, count - run.first));
      batch.runs.push_back(run);
      batch.count += run.count();
      waiting_ += run.count();
    }
  }

  /// The batch that is being filled, with room.
  PrimitiveBatch& open_batch() {
    if (buffers_.used > set_up_ && buffers_.batches[buffers_.used - 1].count < batch_size_) {
      return buffers_.batches[buffers_.used - 1];
    }
    if (buffers_.used == buffers_.batches.size()) buffers_.batches.emplace_back();
    PrimitiveBatch& batch = buffers_.batches[buffers_.used++];
    batch.clear();
    return batch;
  }

  glm::dmat4 clip_from_object_of(std::uint32_t instance) const {
    return input_.viewing.clip_from_object(input_.scene.instances()[instance].world_from_object);
  }

  void transform(std::uint32_t instance, const Mesh& mesh, PlacedVertices& out) {
    out.clip_from_object = clip_from_object_of(instance);
    const std::span<const glm::vec3> positions = mesh.positions.span();
    PlacedVertex* const placed = buffers_.placed.data() + vertices_placed_;
    float* const nearness = buffers_.nearness.data() + vertices_placed_;
    vertices_placed_ += positions.size();
    out.placed = placed;
    out.nearness = nearness;
    input_.executor.for_each((positions.size() + vertex_chunk - 1) / vertex_chunk, [&](std::size_t i, int) {
      const std::size_t first = i * vertex_chunk;
      transform_({&positions[first].x, std::min(vertex_chunk, positions.size() - first),
                  glm::value_ptr(out.clip_from_object), input_.settings.width, input_.settings.height,
                  nullptr, nullptr, placed + first, nearness + first});
    });
    if (!mesh.segments.empty() || !mesh.points.empty()) {
      transform_vertices(positions, out.clip_from_object, out.clip);
    }
    if (input_.sample != pixel_centre) move_vertices({placed, positions.size()});
  }

  /// To what is seen at the sample, see sample_positions.hpp.
  void move_vertices(std::span<PlacedVertex> placed) const {
    for (PlacedVertex& vertex : placed) {
      if (vertex.x == not_snapped) continue;
      vertex = {vertex.x - input_.sample.x, vertex.y - input_.sample.y};
    }
  }

  /// Sets up what waits in batches; where much is set up, it is drawn.
  void set_up_wave() {
    const BatchInput batch_input{input_.scene,   input_.settings,      grid_,
                                 set_up_kernel_, set_up_small_kernel_, input_.sample};
    const auto wave = std::span(buffers_.batches).subspan(set_up_, buffers_.used - set_up_);
    input_.executor.for_each(wave.size(), [&](std::size_t i, int worker) {
      set_up_batch(batch_input, buffers_.vertices, wave[i], worker_of(worker).scratch);
    });
    for (const PrimitiveBatch& batch : wave) {
      counters_ += batch.counters;
      bytes_ += batch.primitives.bytes();
    }
    drawn_ += waiting_;
    waiting_ = 0;
    set_up_ = buffers_.used;
    if (bytes_ > round_bytes || buffers_.used > round_batches) draw_round(false);
  }

  /// Draws what is set up. The last round, which may have nothing left to draw, hands the tiles on.
  void draw_round(bool is_last) {
    if (buffers_.used == 0 && !is_last) return;
    input_.executor.for_each(static_cast<std::size_t>(grid_.count()), [&](std::size_t i, int worker) {
      finish_tile(static_cast<int>(i), worker, is_last && input_.sink != nullptr);
    });
    buffers_.used = set_up_ = 0;
    bytes_ = 0;
    buffer_is_filled_ = true;
    const std::uint32_t primitives = input_.scene.primitive_count();
    input_.progress(primitives == 0 ? 1.0 : static_cast<double>(drawn_) / primitives);
  }

  /// Draws a tile and puts it where it belongs.
  void finish_tile(int index, int worker, bool to_sink) const {
    const int left = grid_.left(index), top = grid_.top(index);
    TileStageBuffers::Worker& own = worker_of(worker);
    const bool is_drawn = draw_tile(index, left, top, own);
    if (to_sink) {
      const bool has_pixels = is_drawn || buffer_is_filled_;
      if (!is_drawn && has_pixels) load(left, top, own.tile);
      const Rect tile = intersect({left, top, tile_size, tile_size}, input_.rect);
      (*input_.sink)(has_pixels ? &own.tile : nullptr, tile, worker);
    } else if (is_drawn || !buffer_is_filled_) {
      if (!is_drawn) load(left, top, own.tile);
      store_tile(own.tile, input_.rect, left, top, buffer_);
    }
  }

  /// @return false if there is nothing to draw; then the tile is not even loaded
  bool draw_tile(int index, int left, int top, TileStageBuffers::Worker& worker) const {
    TilePrimitives* const work = worker.work.make_room(buffers_.used);
    std::size_t count = 0;
    for (const PrimitiveBatch& batch : std::span(buffers_.batches).first(buffers_.used)) {
      work[count] = batch.bins.of_tile(index);
      count += !work[count].is_empty();
    }
    if (count == 0) return false;
    load(left, top, worker.tile);
    velum::draw_tile(raster_, {work, count}, left, top, worker.order, worker.tile, worker.counts);
    return true;
  }

  void load(int left, int top, TileBuffer& tile) const {
    if (buffer_is_filled_) {
      load_tile(buffer_, input_.rect, left, top, tile);
    } else {
      clear_tile(input_.rect, left, top, tile);
    }
  }

  TileStageBuffers::Worker& worker_of(int worker) const {
    return buffers_.workers[static_cast<std::size_t>(worker)];
  }

  const TileStageInput& input_;
  TileStageBuffers& buffers_;
  VisibilityBuffer& buffer_;
  Counters& counters_;
  const TileGrid grid_;
  const std::uint32_t batch_size_ =
      std::max(std::clamp(input_.scene.primitive_count() / most_batches, smallest_batch, largest_batch),
               static_cast<std::uint32_t>(grid_.count()) / tiles_per_primitive);
  const TransformVertices transform_ = transform_kernel(input_.settings.isa);
  const SetUpTriangles set_up_kernel_ = set_up_kernel(input_.settings.isa);
  const SmallSource::SetUp set_up_small_kernel_ = set_up_small_kernel(input_.settings.isa);
  const TileRaster raster_ = tile_raster(input_.settings.isa);
  std::uint32_t instances_waiting_ = 0;  ///< that have vertices in the buffers
  std::uint64_t vertices_waiting_ = 0;   ///< of these, and what the instances take
  std::uint64_t vertices_placed_ = 0;    ///< of these
  std::uint64_t waiting_ = 0;            ///< primitives in batches that are not set up
  std::size_t set_up_ = 0;               ///< as many of the batches in use are
  std::uint64_t bytes_ = 0;              ///< that these take
  std::uint64_t drawn_ = 0;              ///< primitives of all batches that have been set up
  bool buffer_is_filled_ = false;        ///< with what earlier rounds drew
};

}  // namespace

std::uint64_t tile_stage_bytes(const Scene& scene) {
  const std::uint64_t instances =
      std::min<std::uint64_t>(scene.instances().size(), round_vertices / vertices_per_instance);
  const std::uint64_t of_vertices =
      (vertices_of_round(scene) + instances * vertices_per_instance) * bytes_per_vertex;
  const std::uint64_t of_primitives = scene.primitive_count() * std::uint64_t{sizeof(RasterTriangle)};
  return of_vertices + std::min(of_primitives, round_bytes + wave_size * sizeof(RasterTriangle));
}

void draw_in_tiles(const TileStageInput& input, TileStageBuffers& buffers, VisibilityBuffer& buffer,
                   Counters& counters) {
  TileStage(input, buffers, buffer, counters).draw();
}

}  // namespace velum
