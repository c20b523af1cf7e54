// velum-bench: how long a frame takes, scene by scene, with llvmpipe beside it in turn.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "bench_scenes.hpp"
#ifdef VELUM_BENCH_LLVMPIPE
#include "llvmpipe.hpp"
#endif

namespace {

using namespace velum;
using namespace velum_bench;

struct Options {
  std::filesystem::path data = "../shared/data";
  std::vector<std::string> scenes;
  std::string outputs = "colour,depth";
  std::string shading = "triangle-id";
  std::string csv;
  std::string isa = "best";
  int frames = 15;
  int threads = 1;
  bool alone = false;
};

const std::map<std::string, Shading> shadings{{"flat", Shading::flat},
                                              {"gouraud", Shading::gouraud},
                                              {"phong", Shading::phong},
                                              {"triangle-id", Shading::triangle_id}};

std::map<std::string, Isa> isas() {
  std::map<std::string, Isa> names{{"best", Isa::best}};
  for (const Isa isa : available_isas()) names.emplace(name_of(isa), isa);
  return names;
}

/// Milliseconds of frames.
class Times {
 public:
  template <typename Frame>
  void add(const Frame& frame) {
    const auto begin = std::chrono::steady_clock::now();
    frame();
    times_.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
  }
  double median() {
    std::sort(times_.begin(), times_.end());
    return times_.empty() ? 0.0 : times_[times_.size() / 2];
  }
  double spread() {  ///< from the first quarter to the third
    std::sort(times_.begin(), times_.end());
    return times_.empty() ? 0.0 : times_[times_.size() * 3 / 4] - times_[times_.size() / 4];
  }

 private:
  std::vector<double> times_;
};

/// velum with its outputs.
class Velum {
 public:
  Velum(const BenchScene& bench, const Options& options)
      : bench_(bench),
        colour_(bench.width, bench.height),
        depth_(bench.width, bench.height),
        ids_(bench.width, bench.height) {
    const auto wants = [&](const char* name) { return options.outputs.find(name) != std::string::npos; };
    if (wants("colour")) target_.colour = colour_.view();
    if (wants("depth")) target_.depth = depth_.view();
    if (wants("ids")) target_.triangle_id = ids_.view();
    settings_.width = bench.width;
    settings_.height = bench.height;
    settings_.shading = shadings.at(options.shading);
    settings_.threads = options.threads;
    settings_.isa = isas().at(options.isa);
  }
  void draw() { renderer_.render_into(bench_.scene, bench_.camera, settings_, target_); }

  /// As Llvmpipe::coverage().
  std::vector<std::uint8_t> coverage() {
    renderer_.render_into(bench_.scene, bench_.camera, settings_, {.triangle_id = ids_.view()});
    std::vector<std::uint8_t> covered;
    for (int y = 0; y < bench_.height; ++y) {
      for (int x = 0; x < bench_.width; ++x) covered.push_back(ids_.at(x, y) != 0xFFFFFFFFu);
    }
    return covered;
  }

 private:
  const BenchScene& bench_;
  Renderer renderer_;
  RenderSettings settings_;
  Image<Rgba8> colour_;
  Image<float> depth_;
  Image<std::uint32_t> ids_;
  PictureTarget target_;
};

struct Row {
  std::string scene;
  std::uint32_t triangles;
  double velum, velum_spread, llvmpipe, llvmpipe_spread;
  double same_coverage;  ///< share of pixels that both, or neither, cover
};

#ifdef VELUM_BENCH_LLVMPIPE
double share_of_equal(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  std::size_t equal = 0;
  for (std::size_t i = 0; i < a.size(); ++i) equal += a[i] == b[i];
  return static_cast<double>(equal) / static_cast<double>(a.size());
}
#endif

Row measure(const BenchScene& bench, const Options& options) {
  Times ours, theirs;
  Row row{bench.name, bench.scene.primitive_count(), 0, 0, 0, 0, 1.0};
  Velum velum(bench, options);
  velum.draw();
#ifdef VELUM_BENCH_LLVMPIPE
  std::optional<Llvmpipe> llvmpipe;
  if (!options.alone) {
    llvmpipe.emplace(bench);
    llvmpipe->draw();
    row.same_coverage = share_of_equal(velum.coverage(), llvmpipe->coverage());
  }
#endif
  for (int i = 0; i < options.frames; ++i) {
    ours.add([&] { velum.draw(); });
#ifdef VELUM_BENCH_LLVMPIPE
    if (llvmpipe) theirs.add([&] { llvmpipe->draw(); });
#endif
  }
  row.velum = ours.median();
  row.velum_spread = ours.spread();
  row.llvmpipe = theirs.median();
  row.llvmpipe_spread = theirs.spread();
  return row;
}

void print(const Row& row) {
  std::printf("%-12s %10u %9.2f ±%6.2f %9.2f ±%6.2f %8.2f %10.4f %%\n", row.scene.c_str(), row.triangles,
              row.velum, row.velum_spread, row.llvmpipe, row.llvmpipe_spread, row.llvmpipe / row.velum,
              100.0 * row.same_coverage);
  std::fflush(stdout);
}

void run(Options options) {
  if (options.scenes.empty()) options.scenes = scene_names();
  std::ofstream csv;
  if (!options.csv.empty()) {
    csv.open(options.csv);
    csv << "scene,triangles,velum_ms,velum_iqr_ms,llvmpipe_ms,llvmpipe_iqr_ms,ratio,same_coverage\n";
  }
  std::printf("%-12s %10s %17s %17s %8s %12s\n", "scene", "triangles", "velum ms", "llvmpipe ms", "ratio",
              "coverage");
  for (const std::string& name : options.scenes) {
    const auto bench = make_scene(name, options.data);
    if (!bench) {
      std::printf("%-12s its mesh is not in %s\n", name.c_str(), options.data.c_str());
      continue;
    }
    const Row row = measure(*bench, options);
    print(row);
    csv << row.scene << ',' << row.triangles << ',' << row.velum << ',' << row.velum_spread << ','
        << row.llvmpipe << ',' << row.llvmpipe_spread << ',' << row.llvmpipe / row.velum << ','
        << row.same_coverage << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App program("Measures how long a frame takes, 1920x1080; llvmpipe in turn where OSMesa is installed");
  program.add_option("--data", options.data, "Folder of the benchmark meshes and benchmark_cameras.json");
  program.add_option("--scene", options.scenes, "Which scenes (default: all)")
      ->check(CLI::IsMember(scene_names()));
  program.add_option("--outputs", options.outputs, "Any of colour, depth, ids, with commas");
  program.add_option("--shading", options.shading, "How velum shades")->check(CLI::IsMember(&shadings));
  program.add_option("--frames", options.frames, "Frames per scene")->check(CLI::PositiveNumber);
  program.add_option("--threads", options.threads,
                     "velum's threads; 0: all. llvmpipe has the calling one, or one more");
  program.add_option("--isa", options.isa, "velum's instructions")->check(CLI::IsMember(isas()));
  program.add_option("--csv", options.csv, "Write the table to this file, too");
  program.add_flag("--alone", options.alone, "velum only");
  CLI11_PARSE(program, argc, argv);
  // llvmpipe's 1 means its main thread and one worker.
  setenv("LP_NUM_THREADS", options.threads == 1 ? "0" : "1", 0);
  try {
    run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "velum-bench: %s\n", error.what());
    return 1;
  }
}
