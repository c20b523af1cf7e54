#include "structure_measure.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>

#include "embree.hpp"

namespace velum_bench {
namespace {

using namespace velum;

constexpr std::size_t group = 8, every = 16;
constexpr double seconds_per_contender = 0.7;
constexpr std::string_view embree_name = "Embree ROBUST";

std::vector<ViewRay> part_of(const std::vector<ViewRay>& rays) {
  std::vector<ViewRay> part;
  part.reserve(rays.size() / every + group);
  for (std::size_t first = 0; first < rays.size(); first += group * every) {
    const std::size_t end = std::min(first + group, rays.size());
    for (std::size_t i = first; i < end; ++i) part.push_back(rays[i]);
  }
  return part;
}

Patience patience_of(const MeasureOptions& options, double seconds) {
  Patience patience = options.patience;
  patience.clock = Clock::processor;
  patience.seconds = std::min(patience.seconds, seconds);
  return patience;
}

AcceleratorKind kind_named(std::string_view name) {
  for (const AcceleratorName& known : accelerator_names()) {
    if (known.name == name) return known.kind;
  }
  throw std::logic_error("no such structure");
}

/// A structure that was built once, and timed while it was.
struct Built {
  std::string_view name;
  std::unique_ptr<Accelerator> structure;
  double milliseconds;
};

Built build(std::string_view name, const Mesh& mesh) {
  Built built{name, nullptr, 0.0};
  const AcceleratorKind kind = kind_named(name);
  const std::function<void()> once = [&] {
    built.structure = build_accelerator(kind, {mesh.positions.span(), mesh.triangles.span()});
  };
  built.milliseconds = time_in_turn({once}, {Clock::processor, 1, 0.0}).front().first;
  return built;
}

void cast(const Accelerator& structure, const std::vector<ViewRay>& rays, bool any, CastCounters& counters) {
  for (const ViewRay& ray : rays) {
    if (any) {
      structure.is_blocked(ray.ray, ray.range, counters);
    } else {
      structure.first_hit(ray.ray, ray.range, counters);
    }
  }
}

CastCost cost_of(const Timing& timing, std::size_t rays) {
  return {timing.median * 1e6 / static_cast<double>(rays), 0.0, 0.0};
}

/// Casts one kind of rays through all of them in turn. @param rows  of `built`, then Embree's if it is there
void measure_load(std::size_t load, const std::vector<ViewRay>& rays, const std::vector<Built>& built,
                  EmbreeScene* robust, const MeasureOptions& options, std::span<StructureRow> rows) {
  const bool any = structure_loads[load] == "shadow";
  std::vector<std::function<void()>> runs;
  for (const Built& one : built) {
    runs.emplace_back([&] {
      CastCounters counters;
      cast(*one.structure, rays, any, counters);
    });
  }
  const std::vector<FloatRay> floats = float_rays(rays);
  std::vector<std::uint32_t> ids(rays.size());
  if (robust != nullptr)
    runs.emplace_back([&] { any ? robust->any_hits(floats, ids) : robust->first_hits(floats, ids); });
  const std::vector<Timing> timings = time_in_turn(runs, patience_of(options, seconds_per_contender));
  const auto per_ray = [&](std::uint64_t n) {
    return static_cast<double>(n) / static_cast<double>(rays.size());
  };
  for (std::size_t i = 0; i < timings.size(); ++i) {
    CastCost cost = cost_of(timings[i], rays.size());
    if (i < built.size()) {
      CastCounters counters;
      cast(*built[i].structure, rays, any, counters);
      cost.nodes = per_ray(counters.nodes);
      cost.tests = per_ray(counters.tests);
    }
    rows[i].cast[load] = cost;
  }
}

}  // namespace

void measure_structures(const BenchScene& bench, const RayLoads& loads, EmbreeScene* robust,
                        const MeasureOptions& options, std::vector<StructureRow>& rows) {
  const Mesh& mesh = bench.scene.meshes().front();
  const auto triangles = static_cast<double>(mesh.triangles.size());
  std::vector<Built> built;
  std::vector<StructureRow> found;
  for (const std::string_view name : reported_structures) {
    built.push_back(build(name, mesh));
    found.push_back({bench.name,
                     std::string(name),
                     {},
                     built.back().milliseconds,
                     static_cast<double>(built.back().structure->memory()) / triangles});
  }
  if (robust != nullptr) {
    const double milliseconds =
        time_in_turn({[&] { robust->build(); }}, {Clock::processor, 1, 0.0}).front().first;
    found.push_back({bench.name,
                     std::string(embree_name),
                     {},
                     milliseconds,
                     static_cast<double>(robust->memory()) / triangles});
  }
  const std::array<const RayLoad*, 3> kinds{&loads.primary, &loads.incoherent, &loads.shadow};
  for (std::size_t load = 0; load < kinds.size(); ++load)
    measure_load(load, part_of(kinds[load]->rays), built, robust, options, found);
  rows.insert(rows.end(), found.begin(), found.end());
}

}  // namespace velum_bench
