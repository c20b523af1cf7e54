// velum clip-trace: a triangle's way through the six planes of the view volume.
#include <iostream>
#include <memory>
#include <velum/velum.hpp>

#include "camera_options.hpp"
#include "clip_text.hpp"
#include "input.hpp"
#include "outputs.hpp"
#include "trace_json.hpp"
#include "trace_text.hpp"
#include "verb.hpp"

namespace velum_app {
namespace {

using namespace velum;

struct ClipTraceOptions {
  std::string input;
  std::string triangle;
  CameraOptions camera;
  std::optional<std::string> picture;
  bool json = false;
};

constexpr const char* footer =
    "Examples:\n"
    "  velum clip-trace builtin:house --triangle 3\n"
    "  velum clip-trace builtin:house --triangle 3 --projection perspective --eye 0,0.5,1.2 -o clip.png\n"
    "  velum clip-trace bunny.obj --triangle 1000 --near 2 --json";

std::uint32_t triangle_from(const std::string& text, const Scene& scene) {
  const std::uint32_t count = scene.primitive_count();
  const auto number = whole_number_from(text, "--triangle");
  if (number < count) {
    const auto primitive = static_cast<std::uint32_t>(number);
    if (scene.place(primitive).kind == PrimitiveKind::triangle) return primitive;
    throw Error(ErrorKind::usage, "primitive " + text + " is a segment or a point", "--triangle",
                "give the id of a triangle; velum pixel shows which is seen where");
  }
  throw Error(
      ErrorKind::usage, "there is no triangle " + text, "--triangle",
      count == 0 ? "the scene has no triangles" : "give a number from 0 to " + std::to_string(count - 1));
}

int run(const ClipTraceOptions& o) {
  const View view = view_from(o.camera);
  RenderSettings settings;
  settings.width = view.size.width;
  settings.height = view.size.height;
  settings.clip = ClipPolicy::exact;
  std::vector<Output> outputs;
  if (o.picture) outputs.push_back({OutputKind::colour, "--output", *o.picture});
  check_outputs(outputs);

  Scene scene = read_scene(o.input);
  scene.up = view.up_axis();
  const std::uint32_t primitive = triangle_from(o.triangle, scene);
  const Camera camera = frame(scene.points(), view.projection, view.framing);
  const TriangleTrace triangle = trace_triangle(scene, camera, settings, primitive);
  const std::array<glm::dvec4, 3>& v = triangle.assembled.vertices;
  const ClipTrace trace = trace_clipping(v[0], v[1], v[2]);
  if (o.picture) write_drawing(outputs[0], draw_clipping(trace));
  if (o.picture == "-") return exit_ok;
  if (o.json) {
    Json json{{"triangle", primitive},
              {"object", triangle.place.instance},
              {"object_triangle", triangle.place.index}};
    json.update(json_of(trace));
    std::cout << json_text(json);
  } else {
    std::cout << "Triangle " << primitive << " of " << o.input << " (" << place_text(scene, triangle.place)
              << "), projection " << view.projection.name << '\n'
              << clip_text(trace);
  }
  return exit_ok;
}

}  // namespace

Verb add_clip_trace(CLI::App& program) {
  CLI::App* parser =
      program.add_subcommand("clip-trace", "Show how the view volume's planes cut a triangle, one by one");
  const auto options = std::make_shared<ClipTraceOptions>();
  parser->add_option("IN", options->input, input_help)->required()->type_name("");
  parser->add_option("--triangle", options->triangle, "The triangle's id: its place in the scene")
      ->required()
      ->type_name("N");
  parser
      ->add_option("-o,--output", options->picture,
                   "Draw the volume and the polygon after each cut: PNG or PPM")
      ->type_name("FILE");
  parser->add_flag("--json", options->json, "Print JSON");
  options->camera.add_to(*parser);
  parser->footer(footer);
  return {parser, [options] { return run(*options); }};
}

}  // namespace velum_app
