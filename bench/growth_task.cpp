#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <sstream>

#include "llvmpipe.hpp"
#include "machine_limits.hpp"
#include "meshes.hpp"
#include "plots.hpp"
#include "tasks.hpp"
#include "text_file.hpp"

namespace velum_bench {
namespace {

using namespace velum;

constexpr double triangle_counts[] = {1e3, 3e3, 1e4, 3e4, 1e5, 3e5, 1e6, 3e6, 1e7};
/// Widths of pictures of 16:9: 0.1 … 33 million pixels.
constexpr int widths[] = {432, 736, 1296, 1920, 2560, 3840, 5120, 7680};
constexpr double triangles_of_pixel_growth = 1e5;

BenchScene scene_of(const char* name, Mesh mesh, const glm::dvec3& eye) {
  Scene scene;
  scene.add(std::move(mesh));
  const Camera camera =
      Camera::perspective(Pose::towards(eye, {0, 0, 0}, {0, 1, 0}), {VerticalAngle{0.8}}, 0.05, 20.0);
  return {name, std::move(scene), camera};
}
BenchScene sphere(double triangles) {
  return scene_of("sphere", sphere_of(triangles), {1.2, 0.9, 2.2});
}
BenchScene terrain(double triangles) {
  return scene_of("terrain", terrain_of(triangles), {0.9, 0.5, 0.9});
}

/// A curve of the plot and who draws it.
struct Curve {
  std::string name;
  std::string mode;
  bool is_peer = false;
};

/// Draws a scene as the curve wants it, frame after frame. @param bench  outlives it
std::function<void()> contender(const Curve& curve, const BenchScene& bench, const Options& options) {
  const Mode mode = mode_named(curve.mode);
  if (curve.is_peer) {
    const auto llvmpipe = std::make_shared<Llvmpipe>(bench, mode.colour);
    return [llvmpipe] { llvmpipe->draw(); };
  }
  const auto velum = std::make_shared<VelumRunner>(bench, mode, options.measure.velum);
  return [velum] { velum->draw(); };
}

/// What is to be drawn for a point of a curve.
struct Entry {
  Series* series;
  const Curve& curve;
  const BenchScene& bench;
  double x;
};

/// Adds a point to each curve, all of them measured in turn.
void add_points(const std::vector<Entry>& entries, const Options& options) {
  Patience patience = options.measure.patience;
  patience.frames = std::min(patience.frames, 9);
  patience.seconds = std::min(patience.seconds, 4.0);
  std::vector<std::function<void()>> contenders;
  for (const Entry& entry : entries) contenders.push_back(contender(entry.curve, entry.bench, options));
  const std::vector<Timing> timings = time_in_turn(contenders, patience);
  for (std::size_t i = 0; i < entries.size(); ++i)
    entries[i].series->points.push_back({entries[i].x, timings[i].median});
}

/// The curves that this build can draw.
std::vector<Curve> drawable(std::vector<Curve> curves, const Options& options) {
  if (!options.measure.has_peer || !has_llvmpipe())
    std::erase_if(curves, [](const Curve& curve) { return curve.is_peer; });
  return curves;
}

std::vector<Series> empty_series(const std::vector<Curve>& curves) {
  std::vector<Series> series;
  for (const Curve& curve : curves) series.push_back({curve.name, {}});
  return series;
}

LogPlot growth_with_triangles(const Options& options) {
  const auto curves = drawable(
      {{"velum, sphere", "zbuffer"}, {"velum, terrain", "zbuffer"}, {"llvmpipe, sphere", "zbuffer", true}},
      options);
  std::vector<Series> series = empty_series(curves);
  for (const double count : triangle_counts) {
    std::fprintf(stderr, "  %s triangles …\n", tick_label(count).c_str());
    const BenchScene ball = sphere(count), land = terrain(count);
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const BenchScene& bench = curves[i].name.ends_with("terrain") ? land : ball;
      entries.push_back({&series[i], curves[i], bench, static_cast<double>(bench.scene.primitive_count())});
    }
    add_points(entries, options);
  }
  return {"Growth with triangles", "1920×1080; " + machine_description(), "triangles",
          "milliseconds per frame", series};
}

LogPlot growth_with_pixels(const Options& options) {
  const auto curves = drawable({{"velum, colour and depth", "zbuffer"},
                                {"velum, depth only", "depth"},
                                {"llvmpipe, colour and depth", "zbuffer", true}},
                               options);
  std::vector<Series> series = empty_series(curves);
  BenchScene bench = sphere(triangles_of_pixel_growth);
  for (const int width : widths) {
    bench.width = width;
    bench.height = width * 9 / 16;
    std::fprintf(stderr, "  %d×%d …\n", bench.width, bench.height);
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < curves.size(); ++i)
      entries.push_back({&series[i], curves[i], bench, bench.pixels()});
    add_points(entries, options);
  }
  return {"Growth with pixels", "a sphere of 100 k triangles; " + machine_description(), "pixels",
          "milliseconds per frame", series};
}

void report(const LogPlot& plot, const std::string& name, const Options& options) {
  Table table({plot.title, "exponent", "larger half", "smallest, ms", "largest, ms"}, "lrrrr");
  std::ostringstream csv;
  csv << "series," << plot.x_name << ",ms\n";
  for (const Series& series : plot.series) {
    table.add({series.name, fixed(series.exponent(), 2), fixed(series.exponent_of_large(), 2),
               short_figure(series.points.front().y), short_figure(series.points.back().y)});
    for (const Point& p : series.points) csv << '"' << series.name << "\"," << p.x << ',' << p.y << '\n';
  }
  print(table, options);
  write_text(options.out / (name + ".csv"), csv.str());
  write_text(options.out / (name + ".svg"), svg_of(plot));
  std::fprintf(stderr, "%s.csv, .svg: written\n", (options.out / name).c_str());
}

}  // namespace

int run_growth(const Options& options) {
  print_circumstances(options);
  report(growth_with_triangles(options), "growth_triangles", options);
  report(growth_with_pixels(options), "growth_pixels", options);
  return 0;
}

}  // namespace velum_bench
