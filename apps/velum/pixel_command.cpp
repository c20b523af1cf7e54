// velum pixel: why a pixel shows what it shows, and the way of the triangle that is seen there.
#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <velum/velum.hpp>

#include "camera_options.hpp"
#include "fragment_text.hpp"
#include "input.hpp"
#include "line_options.hpp"
#include "outputs.hpp"
#include "trace_json.hpp"
#include "triangle_text.hpp"
#include "verb.hpp"
#include "visibility_options.hpp"

namespace velum_app {
namespace {

using namespace velum;

struct PixelOptions {
  std::string input;
  std::string at;
  std::string cull = "none", radius = "4";
  CameraOptions camera;
  LineOptions lines;
  ClipOption clip;
  std::optional<std::string> picture;
  bool json = false;
};

const std::map<std::string, Cull> cull_names{
    {"none", Cull::none}, {"back", Cull::back}, {"front", Cull::front}};

constexpr const char* footer =
    "Pixels are counted from the top left corner, 0,0; their centres lie at +1/2. Depth is the reversed\n"
    "depth r = 1 - z; the largest r is seen, and of equal ones the lowest id.\n"
    "Examples:\n"
    "  velum pixel builtin:house --at 400,300\n"
    "  velum pixel builtin:house --projection cabinet --at 400,300 -o pixel.png\n"
    "  velum pixel bunny.obj --at 320,240 --size 640x480 --json";

void print_text(const PixelOptions& o, const View& view, const Scene& scene, const Camera& camera,
                const RenderSettings& settings, const PixelExplanation& pixel) {
  std::cout << "Pixel " << pixel.x << ',' << pixel.y << " of " << o.input << ", projection "
            << view.projection.name << ", picture " << settings.width << 'x' << settings.height << '\n'
            << fragments_text(pixel, scene);
  if (!pixel.winner) return;
  std::cout << '\n'
            << triangle_text(*pixel.winner, scene, camera.viewing_transform(view.framing.aspect), settings);
}

/// About as large whatever the radius.
PixelDrawing drawing_from(const PixelOptions& o) {
  constexpr int most = 64, side = 9 * 64;
  const std::uint64_t radius = whole_number_from(o.radius, "--radius");
  if (radius > most) {
    throw Error(ErrorKind::usage, "\"" + o.radius + "\" is too many pixels to draw", "--radius",
                "give 0 to " + std::to_string(most));
  }
  PixelDrawing drawing;
  drawing.radius = static_cast<int>(radius);
  drawing.cell_size = std::clamp(side / (2 * drawing.radius + 1), 8, 64);
  return drawing;
}

int run(const PixelOptions& o) {
  const View view = view_from(o.camera);
  const Pixel at = pixel_from(o.at, "--at");
  RenderSettings settings;
  settings.width = view.size.width;
  settings.height = view.size.height;
  settings.cull = cull_names.at(o.cull);
  o.lines.apply_to(settings);
  o.clip.apply_to(settings);
  std::vector<Output> outputs;
  if (o.picture) outputs.push_back({OutputKind::colour, "--output", *o.picture});
  const PixelDrawing drawing = drawing_from(o);
  check_outputs(outputs);

  Scene scene = read_scene(o.input);
  scene.up = view.up_axis();
  const Camera camera = frame(scene.points(), view.projection, view.framing);
  const PixelExplanation pixel = explain_pixel(scene, camera, settings, at.x, at.y);
  if (o.picture) write_drawing(outputs[0], draw_pixel(pixel, scene, camera, settings, drawing));
  if (o.picture == "-") return exit_ok;
  if (o.json) {
    Json json = json_of(pixel);
    json["size"] = Json::array({settings.width, settings.height});
    if (pixel.winner) {
      const Instance& instance = scene.instances()[pixel.winner->place.instance];
      json["winner"]["world_from_object"] = json_of(instance.world_from_object);
    }
    json["stages"] = json_of(camera.viewing_transform(view.framing.aspect).stages());
    std::cout << json_text(json);
  } else {
    print_text(o, view, scene, camera, settings, pixel);
  }
  return exit_ok;
}

}  // namespace

Verb add_pixel(CLI::App& program) {
  CLI::App* parser = program.add_subcommand("pixel", "Explain why a pixel shows what it shows");
  const auto options = std::make_shared<PixelOptions>();
  parser->add_option("IN", options->input, input_help)->required()->type_name("");
  parser->add_option("--at", options->at, "The pixel")->required()->type_name("X,Y");
  parser->add_option("-o,--output", options->picture, "Draw the pixel's neighbourhood: PNG or PPM")
      ->type_name("FILE");
  parser->add_option("--radius", options->radius, "Pixels drawn to each side of it (default: 4)")
      ->type_name("N");
  parser->add_flag("--json", options->json, "Print JSON");
  parser->add_option("--cull", options->cull, "Triangles left out by the way they face (default: none)")
      ->check(CLI::IsMember(&cull_names));
  options->lines.add_to(*parser);
  options->clip.add_to(*parser);
  options->camera.add_to(*parser);
  parser->footer(footer);
  return {parser, [options] { return run(*options); }};
}

}  // namespace velum_app
