#include <algorithm>
#include <cstdio>

#include "embree.hpp"
#include "goals.hpp"
#include "plots.hpp"
#include "ray_measure.hpp"
#include "tasks.hpp"
#include "text_file.hpp"

namespace velum_bench {

RayFigures measure_ray_scenes(const Options& options) {
  RayFigures figures;
  if (options.measure.has_peer && !has_embree())
    std::fprintf(stderr, "velum-bench: built without Embree: it is left out (install libembree-dev)\n");
  for (const std::string_view scene : ray_scenes) {
    const auto& wanted = options.scenes;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), scene) == wanted.end()) continue;
    std::fprintf(stderr, "  rays: %s …\n", std::string(scene).c_str());
    const auto bench = make_scene(std::string(scene), options.measure.data);
    if (!bench) continue;
    measure_rays(*bench, options.measure, figures);
    const bool has_threads =
        std::find(speedup_scenes.begin(), speedup_scenes.end(), scene) != speedup_scenes.end();
    if (has_threads)
      figures.threads.push_back(measure_threads(*bench, mode_named("raycast"), options.measure));
  }
  return figures;
}

int run_rays(const Options& options) {
  print_circumstances(options);
  const RayFigures figures = measure_ray_scenes(options);
  print(table_of(figures.rows), options);
  print(table_of(figures.structures), options);
  const std::vector<Verdict> verdicts = verdicts_on(figures);
  print(table_of(verdicts), options);
  write_text(options.out / "rays.csv", csv_of(figures.rows));
  write_text(options.out / "structures.csv", csv_of(figures.structures));
  return all_pass(verdicts) ? 0 : 1;
}

}  // namespace velum_bench
