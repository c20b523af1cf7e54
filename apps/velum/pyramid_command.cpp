// velum pyramid IN -o DIR: the z-pyramid of a picture, level by level.
#include <filesystem>
#include <iostream>
#include <memory>
#include <velum/drawing/pyramid_drawing.hpp>
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
    "background is seen is blue: nothing can be hidden behind it.";

/// The picture's depth is z = 1 - r.
Image<float> reversed_depth_of(const Picture& picture) {
  Image<float> depth(picture.depth.width(), picture.depth.height());
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) depth.at(x, y) = 1.0f - picture.depth.at(x, y);
  }
  return depth;
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
  if (!o.quiet) std::cout << folder.string() << ": " << levels.size() << " levels and sheet.png\n";
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
