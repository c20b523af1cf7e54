#include <cstdio>

#include "llvmpipe.hpp"
#include "machine_limits.hpp"
#include "plots.hpp"
#include "report.hpp"
#include "tasks.hpp"
#include "text_file.hpp"

namespace velum_bench {
namespace {

std::string contenders(const Options& options) {
  const int threads = options.measure.velum.threads;
  std::string text =
      "velum (" +
      std::string(velum::name_of(options.measure.velum.isa == velum::Isa::best ? velum::best_isa()
                                                                               : options.measure.velum.isa)) +
      ")";
  if (options.measure.has_peer && has_llvmpipe()) text += " and llvmpipe";
  return text + ", " + (threads == 1 ? "one thread" : std::to_string(threads) + " threads") + " each" +
         (options.is_cpu_time ? ", PROCESSOR TIME" : "");
}

}  // namespace

std::string circumstances(const Options& options) {
  return contenders(options) + "; " + machine_description();
}

void print_circumstances(const Options& options) {
  std::printf("%s\n\n", circumstances(options).c_str());
  if (options.measure.has_peer && !has_llvmpipe())
    std::fprintf(stderr,
                 "velum-bench: built without OSMesa: llvmpipe is left out (install libosmesa6-dev)\n");
  if (load_average() > 0.7)
    std::fprintf(stderr, "velum-bench: the machine is busy with something else: times are too long%s\n",
                 options.is_cpu_time ? "" : " (--cpu-time is steadier)");
  std::fflush(stdout);
}

void print(const Table& table, const Options& options) {
  std::printf("%s\n", (options.is_markdown ? table.markdown() : table.text()).c_str());
  std::fflush(stdout);
}

int run_frames(const Options& options) {
  print_circumstances(options);
  const auto scenes = options.scenes.empty() ? default_scene_names(options.measure.data) : options.scenes;
  std::vector<Row> rows;
  bool agree = true;
  for (const std::string& scene : scenes) {
    std::fprintf(stderr, "  %s …\n", scene.c_str());
    const auto bench = make_scene(scene, options.measure.data);
    if (!bench)
      throw velum::Error(velum::ErrorKind::read, "the files of the scene \"" + scene + "\" are not there",
                         options.measure.data.string(),
                         "give their folder with --data, or take a builtin- scene");
    const auto modes = options.modes.empty() ? std::vector{default_mode(scene)} : options.modes;
    for (const std::string& mode : modes) {
      rows.push_back(measure(*bench, mode_named(mode), options.measure));
      write_text(options.out / "frames.csv", csv_of(rows));  // what is there stays if the rest is broken off
      agree = agree && rows.back().agrees();
    }
  }
  print(table_of(rows), options);
  write_text(options.out / "frames.svg", bar_chart_of(rows, circumstances(options)));
  std::fprintf(stderr, "%s, frames.svg: written\n", (options.out / "frames.csv").c_str());
  return agree ? 0 : 1;
}

}  // namespace velum_bench
