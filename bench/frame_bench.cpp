// velum-bench: how long a frame takes, scene by scene.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "bench_scenes.hpp"

namespace {

using namespace velum;
using namespace velum_bench;

struct Options {
  std::filesystem::path data = "../shared/data";
  std::vector<std::string> scenes;
  std::string outputs = "colour";
  int frames = 15;
  int threads = 1;
  bool reference = false;
};

/// Milliseconds of each frame, sorted.
template <typename Frame>
std::vector<double> times_of(int frames, const Frame& frame) {
  std::vector<double> times;
  frame();
  for (int i = 0; i < frames; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    frame();
    times.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
  }
  std::sort(times.begin(), times.end());
  return times;
}

void measure(const BenchScene& bench, const Options& options) {
  Renderer renderer;
  Image<Rgba8> colour(bench.width, bench.height);
  Image<float> depth(bench.width, bench.height);
  Image<std::uint32_t> ids(bench.width, bench.height);
  PictureTarget target;
  if (options.outputs.find("colour") != std::string::npos) target.colour = colour.view();
  if (options.outputs.find("depth") != std::string::npos) target.depth = depth.view();
  if (options.outputs.find("ids") != std::string::npos) target.triangle_id = ids.view();
  RenderSettings settings;
  settings.width = bench.width;
  settings.height = bench.height;
  settings.shading = Shading::flat;
  settings.threads = options.threads;
  if (options.reference) settings.isa = Isa::reference;
  const std::vector<double> times =
      times_of(options.frames, [&] { renderer.render_into(bench.scene, bench.camera, settings, target); });
  std::printf("%-12s %9u triangles  median %9.2f ms  min %9.2f ms\n", bench.name.c_str(),
              bench.scene.primitive_count(), times[times.size() / 2], times.front());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App program("Measures how long velum takes for a frame");
  program.add_option("--data", options.data, "Folder of the benchmark meshes");
  program.add_option("--scene", options.scenes, "Which scenes (default: all)");
  program.add_option("--outputs", options.outputs, "Any of colour, depth, ids; none: visibility only");
  program.add_option("--frames", options.frames, "Frames per scene");
  program.add_option("--threads", options.threads, "Threads; 0: all");
  program.add_flag("--reference", options.reference, "The plain loops instead of the vector kernels");
  CLI11_PARSE(program, argc, argv);
  if (options.scenes.empty()) options.scenes = scene_names();
  try {
    for (const std::string& name : options.scenes) {
      if (const auto bench = make_scene(name, options.data)) measure(*bench, options);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "velum-bench: %s\n", error.what());
    return 1;
  }
}
