// velum render IN: a mesh file becomes a picture.
#include <array>
#include <iostream>
#include <map>
#include <memory>
#include <velum/pipeline/supersample_stage.hpp>
#include <velum/shading/shading_names.hpp>
#include <velum/velum.hpp>

#include "blank_reason.hpp"
#include "camera_options.hpp"
#include "input.hpp"
#include "line_options.hpp"
#include "outputs.hpp"
#include "report.hpp"
#include "round_shapes.hpp"
#include "terminal_progress.hpp"
#include "text.hpp"
#include "verb.hpp"
#include "visibility_options.hpp"

namespace velum_app {
namespace {

using namespace velum;

const std::map<std::string, Shading> shadings = [] {
  std::map<std::string, Shading> names;
  for (const NamedShading& named : shading_names) names[named.name] = named.shading;
  return names;
}();
const std::map<std::string, Cull> cull_names{
    {"none", Cull::none}, {"back", Cull::back}, {"front", Cull::front}};

const std::map<std::string, TextureFilter> texture_filter_names{{"nearest", TextureFilter::nearest},
                                                                {"bilinear", TextureFilter::bilinear},
                                                                {"trilinear", TextureFilter::trilinear}};

const std::map<std::string, DownsampleFilter> filter_names{{"box", DownsampleFilter::box},
                                                           {"tent", DownsampleFilter::tent},
                                                           {"mitchell", DownsampleFilter::mitchell}};

struct RenderOptions {
  std::string input;
  std::string shading = "phong", cull = "none", background = "transparent";
  std::string texture_filter = "trilinear";
  CameraOptions camera;
  VisibilityOptions visibility;
  LineOptions lines;
  std::string show = "picture";
  bool wireframe = false;
  bool quiet = false;
  bool report_work = false;
  std::optional<std::string> crop;
  std::string layers = "0";
  int samples = 1, supersample = 1;
  std::string filter = "box";
  std::optional<std::string> picture, depth, metric_depth, normals, object_ids, triangle_ids, report;
};

constexpr const char* examples =
    "Examples:\n"
    "  velum render bunny.obj                             bunny.png, framed, lit from the viewer\n"
    "  velum render builtin:cube --projection cabinet     cube.png, the cabinet projection\n"
    "  velum render scan.stl --world-up z --size 1920x1080 --background '#ffffff' -o scan.png\n"
    "  velum render hall.ply --eye 0,2,0 --target 5,2,0 --fov 60 --metric-depth hall.npy\n"
    "  cat part.stl | velum render - -o - > part.png      standard input to standard output\n"
    "Exit codes: 0 ok, 1 nothing to be seen (the picture is still written), 2 usage, 3 cannot read,\n"
    "4 cannot write.";

void add_picture_options(CLI::App& parser, RenderOptions& o) {
  parser.add_option("--background", o.background, "Behind the scene: transparent (default) or #rrggbb")
      ->type_name("COLOUR");
  o.visibility.add_to(parser);
  parser.add_option("--shading", o.shading, "How surfaces are coloured (default: phong)")
      ->check(CLI::IsMember(&shadings));
  parser.add_option("--texture-filter", o.texture_filter, "How textures are filtered (default: trilinear)")
      ->check(CLI::IsMember(&texture_filter_names));
  parser.add_option("--cull", o.cull, "Which triangles are left out by the way they face (default: none)")
      ->check(CLI::IsMember(&cull_names));
  parser
      .add_option(
          "--show", o.show,
          "What -o gets: picture (default), or octree: what the hierarchical method did with each node,\n"
          "from a second camera outside")
      ->check(CLI::IsMember({"picture", "octree"}));
  parser.add_flag("--wireframe", o.wireframe,
                  "Draw the triangles' edges over the picture, hidden ones removed");
  parser.add_option("--samples", o.samples, "Per pixel, for smooth edges: 4, 8 or 16 (default: 1, none)")
      ->check(CLI::IsMember({1, 4, 8, 16}))
      ->type_name("N");
  CLI::Option* const supersample =
      parser
          .add_option("--supersample", o.supersample,
                      "Render N times as large, 2 to 8, and filter down: slower, textures smooth too")
          ->check(CLI::Range(1, most_supersampling))
          ->type_name("N");
  parser
      .add_option("--filter", o.filter,
                  "How --supersample filters: box (default), tent, or mitchell, the sharpest")
      ->check(CLI::IsMember(&filter_names))
      ->needs(supersample);
  o.lines.add_to(parser);
  parser
      .add_option("--layers", o.layers,
                  "Most translucent layers blended per pixel (default: 0, until exhausted)")
      ->type_name("N");
  parser.add_option("--crop", o.crop, "Render only this part of the picture, in pixels from the top left")
      ->type_name("X,Y,W,H");
}

void add_output_options(CLI::App& parser, RenderOptions& o) {
  const auto add = [&parser](const char* name, auto& value, const char* help) {
    parser.add_option(name, value, help)->type_name("FILE")->group("Output");
  };
  add("-o,--output", o.picture, "The picture, .png or .ppm; - is standard output (default: NAME.png)");
  add("--depth", o.depth, "Canonical depth 0 (near) ... 1 (far), .pfm or .npy");
  add("--metric-depth", o.metric_depth, "Distance along the look vector in world units, .pfm or .npy");
  add("--normals", o.normals, "World-space normals, .pfm or .npy");
  add("--object-ids", o.object_ids, "Which instance is seen, .npy; .png shows distinct colours");
  add("--triangle-ids", o.triangle_ids, "Which triangle is seen, .npy; .png shows distinct colours");
  add("--report", o.report, "Coverage, counters, matrices and SHA-256s, .json");
  parser
      .add_flag("--report-work", o.report_work,
                "Report also the visibility method's own work, in which the methods differ")
      ->needs("--report")
      ->group("Output");
  parser.add_flag("--quiet", o.quiet, "Say nothing but errors")->group("Output");
}

/// The trees of --kd-file need a place of their own, too.
void check_kd_file(const RenderOptions& o, const std::vector<Output>& outputs) {
  if (!o.visibility.kd_file) return;
  const auto trees = std::filesystem::path(*o.visibility.kd_file).lexically_normal();
  for (const Output& output : outputs) {
    if (output.path.lexically_normal() != trees) continue;
    throw Error(ErrorKind::usage, "\"" + *o.visibility.kd_file + "\" is also the output of " + output.option,
                "--kd-file", "give the trees a file of their own");
  }
}

/// What a body seen by its equation has not.
void exclude_from_analytic(CLI::App& parser) {
  CLI::Option* const analytic = parser.get_option("--analytic");
  for (const char* name : {"--show", "--layers", "--triangle-ids"}) {
    parser.get_option(name)->excludes(analytic);
  }
}

std::vector<Output> outputs_from(const RenderOptions& o, const RenderSettings& settings) {
  std::vector<Output> outputs;
  outputs.push_back({OutputKind::colour, "-o", o.picture ? *o.picture : stem_of(o.input) + ".png"});
  const auto add = [&outputs](const std::optional<std::string>& path, OutputKind kind, const char* option) {
    if (path) outputs.push_back({kind, option, *path});
  };
  add(o.depth, OutputKind::depth, "--depth");
  add(o.metric_depth, OutputKind::metric_depth, "--metric-depth");
  add(o.normals, OutputKind::normals, "--normals");
  add(o.object_ids, OutputKind::object_ids, "--object-ids");
  add(o.triangle_ids, OutputKind::triangle_ids, "--triangle-ids");
  add(o.report, OutputKind::report, "--report");
  const Rect part = settings.crop.value_or(Rect{0, 0, settings.width, settings.height});
  check_outputs(outputs);
  check_kd_file(o, outputs);
  check_png_sizes(outputs, {part.width, part.height}, settings.background.a == 255);
  return outputs;
}

RenderSettings settings_from(const RenderOptions& o, const Size& size) {
  RenderSettings settings;
  settings.width = size.width;
  settings.height = size.height;
  settings.background = colour_from(o.background, "--background");
  o.visibility.apply_to(settings);
  settings.shading = shadings.at(o.shading);
  settings.texture_filter = texture_filter_names.at(o.texture_filter);
  settings.cull = cull_names.at(o.cull);
  settings.wireframe = o.wireframe;
  settings.samples = o.samples;
  settings.supersample = o.supersample;
  settings.supersample_filter = filter_names.at(o.filter);
  settings.layers = whole_number_from(o.layers, "--layers");
  o.lines.apply_to(settings);
  if (o.crop) settings.crop = rect_from(*o.crop, "--crop");
  settings.progress = terminal_progress(o.quiet);
  return settings;
}

void write_all(const RenderOptions& o, const std::vector<Output>& outputs, const Picture& picture,
               const Scene& scene, const Camera& camera, const RenderSettings& settings) {
  for (const Output& output : outputs) {
    if (output.kind == OutputKind::colour && o.show == "octree") {
      write_drawing(output, draw_octree(scene, camera, settings, settings.width, settings.height));
      continue;
    }
    if (output.kind != OutputKind::report) {
      write_output(output, picture);
      continue;
    }
    Json report = report_of(picture, camera, settings);
    if (o.report_work) report["work"] = work_of(picture.counters);
    const std::string text = json_text(report);
    write_file(output.path, std::as_bytes(std::span(text)));
  }
}

/// "bunny.png: 800x600, perspective, 69,451 triangles, 23 % covered"; on standard error where the picture
/// itself goes to standard output.
void print_summary(const std::vector<Output>& outputs, const Picture& picture, const Projection& projection,
                   bool is_analytic) {
  const Counters& c = picture.counters;
  bool stdout_is_taken = false;
  for (const Output& output : outputs) stdout_is_taken = stdout_is_taken || output.path == "-";
  const std::filesystem::path& path = outputs.front().path;
  (stdout_is_taken ? std::cerr : std::cout)
      << (path == "-" ? "standard output" : path.string()) << ": " << picture.colour.width() << 'x'
      << picture.colour.height() << ", " << projection.name << ", "
      << (is_analytic ? "by its equation"
                      : primitives_text(c.triangles + c.hierarchy.triangles_left_out, c.segments, c.points))
      << ", " << percent_text(picture.coverage()) << " covered\n";
}

/// Samples may colour pixels whose centres nothing covers.
bool is_blank(const Picture& picture, const Rgba8& background) {
  if (picture.coverage() > 0.0) return false;
  for (int y = 0; y < picture.colour.height(); ++y) {
    for (int x = 0; x < picture.colour.width(); ++x) {
      if (picture.colour.at(x, y) != background) return false;
    }
  }
  return true;
}

/// Why nothing is to be seen. What the hierarchical method left out and what rays went by is looked at after
/// all, by the z-buffer.
std::string reason_for(const Scene& scene, const Camera& camera, RenderSettings settings,
                       const Picture& picture) {
  const VisibilityMethod method = settings.visibility;
  if (method != VisibilityMethod::hierarchical && method != VisibilityMethod::raycast) {
    return blank_reason(picture.counters, scene.bounds(), camera, settings);
  }
  settings.visibility = VisibilityMethod::zbuffer;
  settings.progress = nullptr;
  const Picture by_raster = render(scene, camera, settings);
  if (!is_blank(by_raster, settings.background)) return "no ray met a surface";
  return blank_reason(by_raster.counters, scene.bounds(), camera, settings);
}

Picture picture_of(const RenderOptions& o, const Scene& scene, const Camera& camera,
                   const RenderSettings& settings) {
  const ProgressLine line(settings.progress);
  if (!o.visibility.is_analytic) return render(scene, camera, settings);
  return render_analytic(scene, std::array{round_shape(o.input).body}, camera, settings);
}

/// The octree's drawing is one of lines, of the whole picture.
void check_show(const RenderOptions& o, const RenderSettings& settings) {
  if (o.show != "octree") return;
  const bool has_octree = settings.visibility == VisibilityMethod::zbuffer ||
                          settings.visibility == VisibilityMethod::hierarchical;
  if (!has_octree) {
    throw Error(ErrorKind::usage, "octree: shows what the hierarchical method does", "--show",
                "leave out --visibility, or give hierarchical");
  }
  if (settings.crop || settings.samples != 1 || settings.supersample != 1 || settings.wireframe) {
    throw Error(ErrorKind::usage, "octree: is drawn whole and as it is", "--show",
                "leave out --crop, --samples, --supersample and --wireframe");
  }
}

int run(const RenderOptions& o) {
  // Everything that the command line alone decides is checked before work begins.
  const View view = view_from(o.camera);
  RenderSettings settings = settings_from(o, view.size);
  check_show(o, settings);
  const std::vector<Output> outputs = outputs_from(o, settings);
  if (o.visibility.is_analytic) round_shape(o.input);  // refuses what has no equation

  Scene scene = read_scene(o.input);
  scene.up = view.up_axis();
  const Camera camera = frame(scene.points(), view.projection, view.framing);
  o.visibility.prepare_trees(scene, settings);
  const Picture picture = picture_of(o, scene, camera, settings);

  write_all(o, outputs, picture, scene, camera, settings);
  if (!o.quiet) {
    for (const std::string& note : scene.notes) std::cerr << "velum: note: " << note << '\n';
    print_summary(outputs, picture, view.projection, o.visibility.is_analytic);
  }
  if (!is_blank(picture, settings.background)) return exit_ok;
  std::cerr << "velum: the picture is blank: " << reason_for(scene, camera, settings, picture) << '\n';
  return exit_blank;
}

}  // namespace

Verb add_render(CLI::App& program) {
  CLI::App* parser = program.add_subcommand("render", "Make a picture of a mesh file");
  const auto options = std::make_shared<RenderOptions>();
  parser->add_option("IN", options->input, input_help)->required()->type_name("");
  add_output_options(*parser, *options);
  options->camera.add_to(*parser);
  add_picture_options(*parser, *options);
  exclude_from_analytic(*parser);
  parser->footer(examples);
  return {parser, [options] { return run(*options); }};
}

}  // namespace velum_app
