// velum agree: the raster against ray casting, pixel by pixel.
#include <iostream>
#include <map>
#include <memory>
#include <velum/velum.hpp>

#include "agree_analytic_text.hpp"
#include "camera_options.hpp"
#include "input.hpp"
#include "outputs.hpp"
#include "text.hpp"
#include "trace_json.hpp"
#include "verb.hpp"
#include "visibility_options.hpp"

namespace velum_app {
namespace {

using namespace velum;

struct AgreeOptions {
  std::string input;
  std::string cull = "none", accelerator = "bvh";
  CameraOptions camera;
  int threads = 0;
  std::optional<std::string> map;
  bool json = false;
  bool analytic = false;
};

const std::map<std::string, Cull> cull_names{
    {"none", Cull::none}, {"back", Cull::back}, {"front", Cull::front}};

constexpr const char* footer =
    "Both methods see the same triangles; they differ only where a pixel's centre is within 1/362 pixel of\n"
    "an edge (edge) or of a cut with the near or far plane (cut), or two depths are equal within the\n"
    "rounding of float32 (tie). Anything else is a fault, and the exit code is then 1.\n"
    "The map: the scene in faint grey, and on it edge blue, cut yellow, tie green, unexplained red in a "
    "ring.\n"
    "Examples:\n"
    "  velum agree builtin:house\n"
    "  velum agree bunny.obj --projection cabinet -o map.png\n"
    "  velum agree bunny.obj --accelerator kdtree --json\n"
    "  velum agree builtin:sphere --analytic            triangles against the equation, ever finer";

Json id_json(std::uint32_t primitive) {
  return primitive == no_primitive ? Json() : Json(primitive);
}

Json json_of(const AgreementReport& report, const AgreeOptions& o, const RenderSettings& settings) {
  Json counts;
  for (int i = 0; i < agreement_count; ++i) {
    const auto agreement = static_cast<Agreement>(i);
    counts[std::string(agreement_class(agreement).name)] = report.of(agreement);
  }
  Json unexplained = Json::array();
  for (const Difference& d : report.differences) {
    if (d.reason != Agreement::unexplained) continue;
    unexplained.push_back(
        {{"pixel", Json::array({d.x, d.y})}, {"raster", id_json(d.raster)}, {"ray", id_json(d.ray)}});
  }
  return {{"input", o.input},
          {"size", Json::array({settings.width, settings.height})},
          {"accelerator", o.accelerator},
          {"pixels", report.pixels},
          {"covered", report.covered},
          {"classes", counts},
          {"differing_share", report.differing_share()},
          {"unexplained", unexplained}};
}

std::string id_text(std::uint32_t primitive) {
  return primitive == no_primitive ? "the background" : "triangle " + std::to_string(primitive);
}

void print_text(const AgreementReport& report, const AgreeOptions& o, const View& view) {
  constexpr int most_listed = 10;
  std::cout << o.input << ", projection " << view.projection.name << ", " << view.size.width << 'x'
            << view.size.height << ", " << o.accelerator << ": "
            << counted_text(report.covered, "covered pixel") << ", "
            << counted_text(report.differences.size(), "difference") << " ("
            << percent_text(report.differing_share()) << ")\n";
  for (int i = 0; i < agreement_count; ++i) {
    const auto agreement = static_cast<Agreement>(i);
    const AgreementClass& shown = agreement_class(agreement);
    std::cout << "  " << padded_right(std::string(shown.name), 12)
              << padded_left(grouped_text(report.of(agreement)), 12) << "  " << shown.meaning << '\n';
  }
  int listed = 0;
  for (const Difference& d : report.differences) {
    if (d.reason != Agreement::unexplained || listed++ >= most_listed) continue;
    std::cout << "  pixel " << d.x << ',' << d.y << ": the raster sees " << id_text(d.raster) << ", the ray "
              << id_text(d.ray) << '\n';
  }
}

RenderSettings settings_from(const AgreeOptions& o, const Size& size) {
  RenderSettings settings;
  VisibilityOptions visibility;
  visibility.accelerator = o.accelerator;
  visibility.threads = o.threads;
  visibility.apply_to(settings);
  settings.width = size.width;
  settings.height = size.height;
  settings.cull = cull_names.at(o.cull);
  return settings;
}

int run(const AgreeOptions& o) {
  const View view = view_from(o.camera);
  RenderSettings settings = settings_from(o, view.size);
  if (o.analytic) return agree_with_equation(o.input, view, settings, o.json);
  std::vector<Output> outputs;
  if (o.map) outputs.push_back({OutputKind::colour, "-o", *o.map});
  check_outputs(outputs);
  check_json_is_alone(outputs, o.json);
  Scene scene = read_scene(o.input);
  scene.up = view.up_axis();
  const Camera camera = frame(scene.points(), view.projection, view.framing);
  const AgreementReport report = agree(scene, camera, settings);
  if (o.map) {
    settings.shading = Shading::flat;
    write_drawing(outputs[0], draw_agreement(report, render(scene, camera, settings)));
  }
  if (o.map == "-") return report.is_explained() ? exit_ok : exit_different;
  if (o.json) {
    std::cout << json_text(json_of(report, o, settings));
  } else {
    print_text(report, o, view);
  }
  return report.is_explained() ? exit_ok : exit_different;
}

}  // namespace

Verb add_agree(CLI::App& program) {
  CLI::App* parser = program.add_subcommand("agree", "Compare the raster with ray casting, pixel by pixel");
  const auto options = std::make_shared<AgreeOptions>();
  parser->add_option("IN", options->input, input_help)->required()->type_name("");
  CLI::Option* const map =
      parser->add_option("-o,--output", options->map, "Draw a map of the differences: PNG or PPM")
          ->type_name("FILE");
  parser->add_flag("--json", options->json, "Print JSON");
  CLI::Option* const accelerator = add_accelerator_option(*parser, options->accelerator);
  CLI::Option* const cull =
      parser->add_option("--cull", options->cull, "Triangles left out by the way they face (default: none)")
          ->check(CLI::IsMember(&cull_names));
  parser
      ->add_flag("--analytic", options->analytic,
                 "Compare object ids with the shape's equation instead: sphere, icosphere, cylinder")
      ->excludes(map)
      ->excludes(accelerator)
      ->excludes(cull);
  parser->add_option("--threads", options->threads, "How many threads (default: 0, all)")
      ->check(CLI::Range(0, most_threads))
      ->type_name("N");
  options->camera.add_to(*parser);
  parser->footer(footer);
  return {parser, [options] { return run(*options); }};
}

}  // namespace velum_app
