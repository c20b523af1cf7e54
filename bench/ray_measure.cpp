#include "ray_measure.hpp"

#include <algorithm>
#include <functional>
#include <memory>

#include "embree.hpp"

namespace velum_bench {
namespace {

using namespace velum;

/// Nothing here waits for long frames: a few repetitions of each.
constexpr double seconds_per_contender = 1.5;

double share_of_equal(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  std::size_t equal = 0;
  for (std::size_t i = 0; i < a.size(); ++i) equal += a[i] == b[i];
  return a.empty() ? 1.0 : static_cast<double>(equal) / static_cast<double>(a.size());
}

void first_hits(const Accelerator& caster, const std::vector<ViewRay>& rays,
                std::vector<std::uint32_t>& ids) {
  CastCounters counters;
  for (std::size_t i = 0; i < rays.size(); ++i)
    ids[i] = caster.first_hit(rays[i].ray, rays[i].range, counters).triangle;
}

void first_hits_together(const Accelerator& caster, const std::vector<ViewRay>& rays,
                         std::vector<std::uint32_t>& ids) {
  CastCounters counters;
  std::array<RayHit, 8> hits;
  for (std::size_t first = 0; first < rays.size(); first += hits.size()) {
    caster.first_hits({rays.data() + first, hits.size()}, hits, counters);
    for (std::size_t i = 0; i < hits.size(); ++i) ids[first + i] = hits[i].triangle;
  }
}

void any_hits(const Accelerator& caster, const std::vector<ViewRay>& rays, std::vector<std::uint32_t>& ids) {
  CastCounters counters;
  for (std::size_t i = 0; i < rays.size(); ++i)
    ids[i] = caster.is_blocked(rays[i].ray, rays[i].range, counters) ? 0u : no_triangle;
}

using Cast = void (*)(const Accelerator&, const std::vector<ViewRay>&, std::vector<std::uint32_t>&);
using EmbreeCast = void (EmbreeScene::*)(const std::vector<FloatRay>&, std::vector<std::uint32_t>&) const;

/// velum's structure and Embree's two over one mesh.
struct Contenders {
  std::unique_ptr<Accelerator> velum;
  std::unique_ptr<EmbreeScene> embree, robust;  ///< none where Embree is not built in

  Contenders(const Mesh& mesh, bool has_peer) : velum(build(mesh)) {
    if (!has_peer || !has_embree()) return;
    embree = std::make_unique<EmbreeScene>(mesh, false);
    robust = std::make_unique<EmbreeScene>(mesh, true);
  }
  static std::unique_ptr<Accelerator> build(const Mesh& mesh) {
    return build_accelerator(AcceleratorKind::bvh, {mesh.positions.span(), mesh.triangles.span()});
  }
};

RayRow timed(RayRow row, const std::vector<std::function<void()>>& contenders,
             const MeasureOptions& options) {
  Patience patience = options.patience;
  patience.clock = Clock::processor;
  patience.seconds = std::min(patience.seconds, seconds_per_contender);
  const std::vector<Timing> timings = time_in_turn(contenders, patience);
  row.velum = timings[0];
  if (timings.size() > 1) row.embree = timings[1];
  if (timings.size() > 2) row.robust = timings[2];
  return row;
}

RayRow cast(const std::string& scene, const std::string& what, const RayLoad& load,
            const Contenders& contenders, Cast velum_cast, EmbreeCast embree_cast,
            const MeasureOptions& options) {
  std::vector<std::uint32_t> ids(load.rays.size()), plain = ids, robust = ids;
  const std::vector<FloatRay> rays = float_rays(load.rays);
  std::vector<std::function<void()>> runs{[&] { velum_cast(*contenders.velum, load.rays, ids); }};
  if (contenders.embree) {
    runs.emplace_back([&] { (contenders.embree.get()->*embree_cast)(rays, plain); });
    runs.emplace_back([&] { (contenders.robust.get()->*embree_cast)(rays, robust); });
  }
  RayRow row;
  row.scene = scene;
  row.what = what;
  row.count = load.rays.size();
  row = timed(row, runs, options);
  if (contenders.embree) row.same = share_of_equal(ids, robust);
  return row;
}

RayRow build(const std::string& scene, const Mesh& mesh, const Contenders& contenders,
             const MeasureOptions& options) {
  std::vector<std::function<void()>> runs{[&] { Contenders::build(mesh); }};
  if (contenders.embree) {
    runs.emplace_back([&] { contenders.embree->build(); });
    runs.emplace_back([&] { contenders.robust->build(); });
  }
  RayRow row;
  row.scene = scene;
  row.what = "build";
  row.count = mesh.triangles.size();
  return timed(row, runs, options);
}

}  // namespace

std::optional<double> RayRow::ratio() const {
  if (!robust) return {};
  return robust->median / velum.median;
}

void measure_rays(const BenchScene& bench, const MeasureOptions& options, RayFigures& figures) {
  const Mesh& mesh = bench.scene.meshes().front();
  const Contenders contenders(mesh, options.has_peer);
  const RayLoads loads = make_ray_loads(bench, *contenders.velum);
  const auto add = [&](const char* what, const RayLoad& load, Cast velum_cast, EmbreeCast embree_cast) {
    figures.rows.push_back(cast(bench.name, what, load, contenders, velum_cast, embree_cast, options));
  };
  add("primary, packets", loads.primary, first_hits_together, &EmbreeScene::first_hits_by_eight);
  add("primary, single", loads.primary, first_hits, &EmbreeScene::first_hits);
  add("incoherent", loads.incoherent, first_hits, &EmbreeScene::first_hits);
  add("shadow", loads.shadow, any_hits, &EmbreeScene::any_hits);
  figures.rows.push_back(build(bench.name, mesh, contenders, options));
  figures.memory.push_back({bench.name, mesh.triangles.size(),
                            static_cast<std::int64_t>(contenders.velum->memory()),
                            contenders.robust ? contenders.robust->memory() : 0});
  measure_structures(bench, loads, contenders.robust.get(), options, figures.structures);
}

}  // namespace velum_bench
