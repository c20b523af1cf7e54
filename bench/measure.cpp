#include "measure.hpp"

#include "llvmpipe.hpp"
#include "memory.hpp"

namespace velum_bench {
namespace {

double share_of_equal(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  std::size_t equal = 0;
  for (std::size_t i = 0; i < a.size(); ++i) equal += a[i] == b[i];
  return static_cast<double>(equal) / static_cast<double>(a.size());
}

Row row_of(const BenchScene& bench, const Mode& mode) {
  Row row;
  row.scene = bench.name;
  row.mode = mode.name;
  row.pixels = bench.pixels();
  row.triangles = bench.scene.primitive_count();
  row.bytes = row.pixels * mode.bytes_per_pixel();
  for (const velum::Mesh& mesh : bench.scene.meshes()) {
    row.bytes += static_cast<double>(mesh.positions.size() * sizeof(glm::vec3) +
                                     mesh.triangles.size() * sizeof(glm::uvec3));
  }
  return row;
}

}  // namespace

std::optional<double> Row::ratio() const {
  if (!llvmpipe) return {};
  return llvmpipe->median / velum.median;
}

bool Row::agrees() const {
  return !same_coverage || *same_coverage >= least_same_coverage;
}

Row measure(const BenchScene& bench, const Mode& mode, const MeasureOptions& options) {
  Row row = row_of(bench, mode);
  VelumRunner velum(bench, mode, options.velum);
  std::vector<std::function<void()>> contenders{[&] { velum.draw(); }};
  std::optional<Llvmpipe> llvmpipe;
  if (options.has_peer && has_llvmpipe()) {
    llvmpipe.emplace(bench, mode.colour);
    contenders.emplace_back([&] { llvmpipe->draw(); });
  }
  const std::vector<Timing> timings = time_in_turn(contenders, options.patience);
  row.velum = timings[0];
  row.vertices = velum.counters().vertices;
  row.left_out = velum.counters().hierarchy.triangles_left_out;
  if (llvmpipe) {
    row.llvmpipe = timings[1];
    row.same_coverage = share_of_equal(velum.coverage(), llvmpipe->coverage());
  }
  if (options.has_memory) row.memory = memory_in_child(bench.name, mode.name, options);
  return row;
}

std::optional<std::uint64_t> memory_in_child(const std::string& scene, const std::string& mode,
                                             const MeasureOptions& options) {
  return number_from_child({"--memory-here", "--data", options.data.string(), "--scene", scene, "--mode",
                            mode, "--threads", std::to_string(options.velum.threads), "--isa",
                            velum::name_of(options.velum.isa)});
}

std::optional<std::uint64_t> memory_here(const std::string& scene, const std::string& mode,
                                         const MeasureOptions& options) {
  const auto bench = make_scene(scene, options.data);
  if (!bench || !reset_peak_memory()) return {};
  const auto before = resident_memory();
  VelumRunner velum(*bench, mode_named(mode), options.velum);
  for (int frame = 0; frame < 3; ++frame) velum.draw();
  const auto peak = peak_memory();
  if (!before || !peak || *peak < *before) return {};
  return *peak - *before;
}

ThreadRow measure_threads(const BenchScene& bench, const Mode& mode, const MeasureOptions& options) {
  VelumOptions one = options.velum, two = options.velum;
  one.threads = 1;
  two.threads = 2;
  VelumRunner single(bench, mode, one), pair(bench, mode, two);
  Patience patience = options.patience;
  patience.clock = Clock::wall;
  const std::vector<Timing> timings = time_in_turn({[&] { single.draw(); }, [&] { pair.draw(); }}, patience);
  return {bench.name, mode.name, timings[0], timings[1]};
}

}  // namespace velum_bench
