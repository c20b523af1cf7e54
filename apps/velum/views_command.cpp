// velum views IN: a sheet of views, as a draughtsman lays them out.
#include <iostream>
#include <map>
#include <memory>
#include <velum/velum.hpp>

#include "input.hpp"
#include "json_values.hpp"
#include "outputs.hpp"
#include "parse_values.hpp"
#include "verb.hpp"

namespace velum_app {
namespace {

using namespace velum;

const std::map<std::string, SheetLayout> layout_names{{"four", SheetLayout::four}, {"six", SheetLayout::six}};
const std::map<std::string, SheetAngle> angle_names{{"first", SheetAngle::first},
                                                    {"third", SheetAngle::third}};

struct ViewsOptions {
  std::string input;
  std::string layout = "six", angle = "first", size = "1200x900", world_up = "y";
  std::optional<std::string> picture, report;
  bool quiet = false;
};

constexpr const char* examples =
    "Examples:\n"
    "  velum views builtin:house -o house.png                        all six principal views, first angle\n"
    "  velum views part.stl --layout four --angle third --world-up z front, top, right and a perspective\n"
    "First angle has the top view below the front view and the left view to its right; third angle the "
    "reverse.";

Json json_of_view(const SheetView& view) {
  const Rect& r = view.rect;
  const double aspect = static_cast<double>(r.width) / r.height;
  return {{"name", view.name},
          {"rect", Json::array({r.left, r.top, r.right(), r.bottom()})},
          {"pixels_per_unit", view.pixels_per_unit},
          {"camera", json_of(view.camera)},
          {"stages", json_of(view.camera.viewing_transform(aspect).stages())}};
}

void write_report(const ViewsOptions& o, const Sheet& sheet) {
  Json views = Json::array();
  for (const SheetView& view : sheet.views) views.push_back(json_of_view(view));
  const Json report{{"size", Json::array({sheet.picture.width(), sheet.picture.height()})},
                    {"layout", o.layout},
                    {"angle", o.angle},
                    {"pixels_per_unit", sheet.pixels_per_unit},
                    {"views", views}};
  const std::string text = json_text(report);
  write_file(*o.report, std::as_bytes(std::span(text)));
}

std::vector<Output> outputs_from(const ViewsOptions& o, const Size& size) {
  std::vector<Output> outputs;
  outputs.push_back({OutputKind::colour, "-o", o.picture ? *o.picture : stem_of(o.input) + "-views.png"});
  if (o.report) outputs.push_back({OutputKind::report, "--report", *o.report});
  check_outputs(outputs);
  check_png_sizes(outputs, size, true);
  return outputs;
}

int run(const ViewsOptions& o) {
  const Size size = size_from(o.size, "--size");
  const std::vector<Output> outputs = outputs_from(o, size);
  const std::filesystem::path& path = outputs.front().path;

  Scene scene = read_scene(o.input);
  scene.up = o.world_up == "z" ? UpAxis::z : UpAxis::y;
  SheetOptions options;
  options.layout = layout_names.at(o.layout);
  options.angle = angle_names.at(o.angle);
  options.width = size.width;
  options.height = size.height;
  const Sheet sheet = draw_sheet(scene, options);
  write_drawing(outputs.front(), sheet.picture);
  if (o.report) write_report(o, sheet);
  if (!o.quiet && path != "-") {
    std::cout << path.string() << ": " << size.width << 'x' << size.height << ", " << sheet.views.size()
              << " views, " << o.angle << " angle\n";
  }
  return exit_ok;
}

}  // namespace

Verb add_views(CLI::App& program) {
  CLI::App* parser = program.add_subcommand("views", "Draw a sheet of views in one scale");
  const auto options = std::make_shared<ViewsOptions>();
  parser->add_option("IN", options->input, input_help)->required()->type_name("");
  parser
      ->add_option("-o,--output", options->picture,
                   "The sheet, .png or .ppm; - is standard output (default: NAME-views.png)")
      ->type_name("FILE");
  parser->add_option("--layout", options->layout, "Which views (default: six)")
      ->check(CLI::IsMember(&layout_names));
  parser->add_option("--angle", options->angle, "Where they stand (default: first)")
      ->check(CLI::IsMember(&angle_names));
  parser->add_option("--size", options->size, "Of the whole sheet in pixels (default: 1200x900)")
      ->type_name("WxH");
  parser->add_option("--world-up", options->world_up, "The world's up axis (default: y)")
      ->check(CLI::IsMember({"y", "z"}));
  parser->add_option("--report", options->report, "Each view's place, camera and stages, .json")
      ->type_name("FILE");
  parser->add_flag("--quiet", options->quiet, "Say nothing but errors");
  parser->footer(examples);
  return {parser, [options] { return run(*options); }};
}

}  // namespace velum_app
