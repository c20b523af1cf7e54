// velum pyramid IN -o DIR: the z-pyramid of a picture, level by level.
#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <velum/velum.hpp>

#include "blank_reason.hpp"
#include "camera_options.hpp"
#include "input.hpp"
#include "outputs.hpp"
#include "verb.hpp"

namespace velum_app {
namespace {

using namespace velum;

struct PyramidOptions {
  std::string input, folder;
  CameraOptions camera;
  bool quiet = false;
};

constexpr const char* examples =
    "Examples:\n"
    "  velum pyramid builtin:house -o levels             levels/level-00.png ... and levels/sheet.png\n"
    "Level 0 is the z-buffer; each further level has the farthest of four. Near is light; a block in which\n"
    "background is seen is blue: nothing can be hidden behind it. The table tells for each level the share "
    "of\n"
    "the picture behind which it can hide something, and how many octree nodes and polygons the "
    "hierarchical\n"
    "method rejects there: a level without a block free of background can reject nothing.";

/// What the hierarchical method rejects of the same picture. Scenes of the command line are often small:
/// nodes and batches of a fortieth of the scene leave something to decide. The second frame knows what the
/// first one showed.
HierarchyCounters rejected_from(const Scene& scene, const Camera& camera, RenderSettings settings) {
  const std::uint32_t part = scene.primitive_count() / 40;
  settings.visibility = VisibilityMethod::hierarchical;
  settings.hierarchy.leaf_size = std::clamp(part, 8u, 384u);
  settings.hierarchy.batch_size = std::clamp(part, 8u, 1u << 18);
  Renderer renderer;
  renderer.render(scene, camera, settings);
  return renderer.render(scene, camera, settings).counters.hierarchy;
}

void print_levels(const ZPyramid& pyramid, const HierarchyCounters& rejected) {
  std::cout << "level         size  can hide  nodes rejected  polygons rejected\n";
  for (int i = 0; i < pyramid.levels(); ++i) {
    const ImageView<const float> level = pyramid.level(i);
    std::cout << std::setw(5) << i << std::setw(13)
              << std::to_string(level.width) + "x" + std::to_string(level.height) << std::setw(8)
              << static_cast<int>(100.0 * share_that_hides(pyramid, i)) << " %" << std::setw(16)
              << rejected.nodes_hidden_at[i] << std::setw(19) << rejected.polygons_hidden_at[i] << '\n';
  }
}

void write(const std::filesystem::path& folder, const std::string& name, const Image<Rgba8>& picture) {
  write_drawing({OutputKind::colour, "-o", folder / name}, picture);
}

int run(const PyramidOptions& o) {
  const View view = view_from(o.camera);
  Scene scene = read_scene(o.input);
  scene.up = view.up_axis();
  RenderSettings settings;
  settings.width = view.size.width;
  settings.height = view.size.height;
  settings.shading = Shading::depth;
  const Camera camera = frame(scene.points(), view.projection, view.framing);
  const Picture picture = render(scene, camera, settings);
  const Image<float> depth = reversed_depth_of(picture);
  ZPyramid pyramid;
  pyramid.build(depth);

  const std::filesystem::path folder = o.folder;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Error(ErrorKind::write, error.message(), o.folder, "name a folder that can be made");
  const std::vector<Image<Rgba8>> levels = draw_pyramid_levels(pyramid);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    write(folder, std::string("level-") + (i < 10 ? "0" : "") + std::to_string(i) + ".png", levels[i]);
  }
  write(folder, "sheet.png", draw_pyramid_sheet(pyramid));
  if (!o.quiet) {
    std::cout << folder.string() << ": " << levels.size() << " levels and sheet.png\n";
    print_levels(pyramid, rejected_from(scene, camera, settings));
  }
  if (picture.coverage() > 0.0) return exit_ok;
  std::cerr << "velum: the picture is blank: "
            << blank_reason(picture.counters, scene.bounds(), camera, settings) << '\n';
  return exit_blank;
}

}  // namespace

Verb add_pyramid(CLI::App& program) {
  CLI::App* parser = program.add_subcommand("pyramid", "Draw the z-pyramid of a picture, level by level");
  const auto options = std::make_shared<PyramidOptions>();
  parser->add_option("IN", options->input, input_help)->required()->type_name("");
  parser->add_option("-o,--output", options->folder, "The folder for the pictures")
      ->required()
      ->type_name("DIR");
  options->camera.add_to(*parser);
  parser->add_flag("--quiet", options->quiet, "Say nothing but errors");
  parser->footer(examples);
  return {parser, [options] { return run(*options); }};
}

}  // namespace velum_app
