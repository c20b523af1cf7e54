#include "options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>
#include <thread>

namespace velum_bench {
namespace {

using namespace velum;

const std::map<std::string, Shading> shadings{{"flat", Shading::flat},
                                              {"gouraud", Shading::gouraud},
                                              {"phong", Shading::phong},
                                              {"triangle-id", Shading::triangle_id}};

std::map<std::string, Isa> isas() {
  std::map<std::string, Isa> names{{"best", Isa::best}};
  for (const Isa isa : available_isas()) names.emplace(name_of(isa), isa);
  return names;
}

template <typename Value>
std::string names_of(const std::map<std::string, Value>& values) {
  std::string names;
  for (const auto& [name, value] : values) names += (names.empty() ? "" : ",") + name;
  return names;
}

std::vector<std::string> mode_names() {
  std::vector<std::string> names;
  for (const Mode& mode : modes()) names.push_back(mode.name);
  return names;
}

void add_tasks(CLI::App& program, Options& options) {
  auto* check =
      program.add_flag("--check", options.is_check,
                       "Measure what velum set out to reach; a line per goal; exit code 1 if one fails");
  auto* growth = program.add_flag("--growth", options.is_growth,
                                  "How time grows with triangles and with pixels, with fitted exponents");
  auto* limits = program.add_flag("--limits", options.is_limits, "Only what the machine itself can do");
  auto* rays = program.add_flag("--rays", options.is_rays,
                                "Only casting rays, one thread, processor time, with Embree beside it");
  check->excludes(growth)->excludes(limits)->excludes(rays);
  growth->excludes(limits)->excludes(rays);
  limits->excludes(rays);
  program.add_flag("--memory-here", options.is_memory_here)->group("");
}

void add_measuring(CLI::App& program, Options& options) {
  VelumOptions& velum = options.measure.velum;
  program.add_option("--shading", velum.shading, "How velum shades (default: triangle-id)")
      ->transform(CLI::CheckedTransformer(shadings).description(""))
      ->type_name("{" + names_of(shadings) + "}");
  program.add_option("--isa", velum.isa, "velum's instructions (default: best)")
      ->transform(CLI::CheckedTransformer(isas()).description(""))
      ->type_name("{" + names_of(isas()) + "}");
  program.add_option("--threads", velum.threads, "Threads of each contender; 0: all the machine has")
      ->check(CLI::Range(0, most_threads))
      ->capture_default_str();
  program.add_option("--frames", options.measure.patience.frames, "Frames per scene and contender")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  program
      .add_option(
          "--seconds", options.measure.patience.seconds,
          "At most so long per scene and contender: fewer frames where they take longer, one at least")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  program.add_flag(
      "--cpu-time", options.is_cpu_time,
      "Processor time instead of what a person waits: steadier on a busy machine; one thread only");
  program.add_flag("--alone", options.is_alone, "velum only");
  program.add_flag("!--no-memory", options.measure.has_memory, "Do not measure memory");
}

}  // namespace

ParsedOptions parse_options(int argc, char** argv) {
  Options options;
  CLI::App program(
      "Measures how long a frame of velum takes, 1920x1080, with Mesa's llvmpipe in turn where OSMesa is\n"
      "installed. Prints a table and leaves it as CSV and as a bar chart (SVG) in the folder --out.");
  add_tasks(program, options);
  program.add_option("--data", options.measure.data, "Folder of the benchmark meshes and cameras")
      ->capture_default_str();
  program.add_option("--scene", options.scenes, "Which scenes (default: all whose files are there)")
      ->check(CLI::IsMember(scene_names()));
  program.add_option("--mode", options.modes, "What velum is asked for (default: as the scene wants it)")
      ->check(CLI::IsMember(mode_names()));
  add_measuring(program, options);
  program.add_option("--out", options.out, "Folder for CSV and SVG")->capture_default_str();
  program.add_flag("--markdown", options.is_markdown, "Print tables as Markdown");
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return {{}, program.exit(error) == 0 ? 0 : 2};
  }
  if (options.measure.velum.threads == 0)
    options.measure.velum.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  if (options.is_cpu_time) options.measure.patience.clock = Clock::processor;
  if (options.is_cpu_time && options.measure.velum.threads != 1 && !options.is_check) {
    std::fprintf(stderr,
                 "velum-bench: --cpu-time sums all threads up; it says something with --threads 1 only\n");
    return {{}, 2};
  }
  if (options.is_check || options.is_rays) options.measure.velum.threads = 1;
  options.measure.has_peer = !options.is_alone;
  return {options, 0};
}

}  // namespace velum_bench
