// velum ray: what the ray through a pixel's centre meets, and how it is found.
#include "ray_command.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <velum/velum.hpp>

#include "camera_options.hpp"
#include "input.hpp"
#include "json_values.hpp"
#include "outputs.hpp"
#include "parse_values.hpp"
#include "text.hpp"
#include "visibility_options.hpp"

namespace velum_app {
namespace {

using namespace velum;

struct RayOptions {
  std::string input;
  std::string pixel;
  std::string accelerator = "bvh";
  CameraOptions camera;
  std::string output;
  std::optional<std::string> depth;
  bool traversal = false;
  bool json = false;
};

constexpr const char* footer =
    "t runs from 0 on the near plane to 1 on the far plane. --traversal lists the boxes of the binary\n"
    "hierarchies, whatever the accelerator, in the order in which they are looked at: first that over the\n"
    "instances, in world space, then that of each instance, in its object space; indented by level, with\n"
    "the number of the step.\n"
    "-o draws the same from the side, in panels that go deeper and deeper.\n"
    "Examples:\n"
    "  velum ray builtin:house --pixel 400,300\n"
    "  velum ray bunny.obj --pixel 320,240 --size 640x480 --traversal --depth 6 -o boxes.png";

int depth_of(const RayOptions& o) {
  constexpr std::uint64_t all = 1000;  // no hierarchy is as deep
  if (!o.depth) return all;
  return static_cast<int>(std::min(all, whole_number_from(*o.depth, "--depth")));
}

const char* name_of(const RayStep& step) {
  if (step.kind == RayStep::Kind::triangle) return "triangle";
  if (step.kind == RayStep::Kind::instance) return "instance";
  return step.is_leaf ? "leaf" : "box";
}

/// The part of the ray in a box, or the t of a hit.
bool has_interval(const RayStep& step) {
  return step.kind != RayStep::Kind::instance && step.outcome != RayStep::Outcome::missed;
}

std::string point_text(const glm::dvec3& p) {
  return "(" + number_text(p.x) + ", " + number_text(p.y) + ", " + number_text(p.z) + ")";
}

/// "t = 0.3", or where the ray passes by a box.
std::string place_text(const RayStep& step) {
  if (step.kind == RayStep::Kind::box && step.outcome == RayStep::Outcome::missed) {
    return " (t " + number_text(step.gap.left, 4) + " < " + number_text(step.gap.entered, 4) + ")";
  }
  if (!has_interval(step)) return "";
  if (step.kind == RayStep::Kind::triangle) return ", t = " + number_text(step.inside.lower);
  return ", t " + number_text(step.inside.lower) + " ... " + number_text(step.inside.upper);
}

void print_step(const RayStep& step, std::size_t number) {
  const std::string at = std::to_string(number);
  std::cout << padded_left(at, 5) << std::string(2 * static_cast<std::size_t>(step.level) + 2, ' ')
            << name_of(step) << ' ' << step.index;
  if (step.kind == RayStep::Kind::box) {
    std::cout << ' ' << point_text(glm::dvec3(step.box.lower)) << " ... "
              << point_text(glm::dvec3(step.box.upper));
  }
  std::cout << ": " << reason_of(step) << place_text(step) << '\n';
}

/// Steps deeper than `depth` are counted only.
void print_steps(const std::vector<RayStep>& steps, int depth) {
  std::size_t deeper = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].level <= depth) print_step(steps[i], i);
    deeper += steps[i].level > depth;
    const bool is_last_of_run = i + 1 == steps.size() || steps[i + 1].level <= depth;
    if (deeper == 0 || !is_last_of_run) continue;
    std::cout << std::string(2 * static_cast<std::size_t>(depth) + 9, ' ') << "... "
              << counted_text(deeper, "deeper step") << '\n';
    deeper = 0;
  }
}

/// The tree that steps are of, whatever the accelerator.
constexpr const char* walked_tree = "binary-bvh";

std::string whose_steps(const RayOptions& o) {
  const std::string walked = std::string(" of the binary hierarchy (") + walked_tree;
  return walked + (o.accelerator == walked_tree ? ")" : "; the counts above are of " + o.accelerator + ")");
}

void print_text(const RayOptions& o, const RayExplanation& ray) {
  std::cout << "The ray through pixel " << ray.x << ',' << ray.y << " of " << o.input << '\n'
            << "  from " << point_text(ray.ray.ray.origin) << " along " << point_text(ray.ray.ray.direction)
            << ", t " << number_text(ray.ray.range.lower) << " ... " << number_text(ray.ray.range.upper)
            << '\n'
            << "  " << o.accelerator << ": " << counted_text(ray.counters.nodes, "node") << ", "
            << counted_text(ray.counters.boxes, "box test") << ", "
            << counted_text(ray.counters.tests, "triangle test") << '\n';
  if (ray.hits.empty()) std::cout << "It meets nothing.\n";
  if (!ray.hits.empty()) std::cout << "It meets, nearest first:\n";
  for (const SceneHit& hit : ray.hits) {
    std::cout << "  t = " << number_text(hit.t) << ", triangle " << hit.primitive << " (instance "
              << hit.instance << ", its triangle " << hit.triangle << "), at "
              << point_text(ray.ray.ray.at(hit.t)) << '\n';
  }
  if (!o.traversal) return;
  std::cout << "The way through the boxes" << whose_steps(o) << ":\n";
  print_steps(ray.traversal, depth_of(o));
}

Json vector_json(const glm::dvec3& v) {
  return Json::array({v.x, v.y, v.z});
}

Json json_of(const SceneHit& hit, const Ray& ray) {
  return {{"t", hit.t},
          {"primitive", hit.primitive},
          {"instance", hit.instance},
          {"triangle", hit.triangle},
          {"barycentric", vector_json(hit.barycentric)},
          {"position", vector_json(ray.at(hit.t))}};
}

Json json_of(const RayStep& step, std::size_t number) {
  Json json{{"step", number}, {"level", step.level}, {"kind", name_of(step)}, {"index", step.index}};
  if (step.kind == RayStep::Kind::box) {
    json["box"] =
        Json::array({vector_json(glm::dvec3(step.box.lower)), vector_json(glm::dvec3(step.box.upper))});
  }
  if (step.kind == RayStep::Kind::box && step.outcome == RayStep::Outcome::missed) {
    json["leaves"] = step.gap.left;
    json["enters"] = step.gap.entered;
  }
  if (has_interval(step)) json["t"] = Json::array({step.inside.lower, step.inside.upper});
  json["outcome"] = reason_of(step);
  return json;
}

Json json_of(const RayOptions& o, const RayExplanation& ray) {
  Json json{{"input", o.input},
            {"pixel", Json::array({ray.x, ray.y})},
            {"origin", vector_json(ray.ray.ray.origin)},
            {"direction", vector_json(ray.ray.ray.direction)},
            {"accelerator", o.accelerator},
            {"nodes", ray.counters.nodes},
            {"boxes", ray.counters.boxes},
            {"tests", ray.counters.tests},
            {"hits", Json::array()}};
  for (const SceneHit& hit : ray.hits) json["hits"].push_back(json_of(hit, ray.ray.ray));
  if (!o.traversal) return json;
  json["traversal_of"] = walked_tree;
  json["traversal"] = Json::array();
  for (std::size_t i = 0; i < ray.traversal.size(); ++i) {
    const RayStep& step = ray.traversal[i];
    if (step.level <= depth_of(o)) json["traversal"].push_back(json_of(step, i));
  }
  return json;
}

int run(const RayOptions& o) {
  const View view = view_from(o.camera);
  RayDrawing drawing;
  drawing.depth = depth_of(o);
  const std::vector<Output> outputs =
      o.output.empty() ? std::vector<Output>{} : std::vector<Output>{{OutputKind::colour, "-o", o.output}};
  check_outputs(outputs);
  check_json_is_alone(outputs, o.json);
  const Pixel at = pixel_from(o.pixel, "--pixel");
  RenderSettings settings;
  VisibilityOptions visibility;
  visibility.accelerator = o.accelerator;
  visibility.apply_to(settings);
  settings.width = view.size.width;
  settings.height = view.size.height;
  Scene scene = read_scene(o.input);
  scene.up = view.up_axis();
  const Camera camera = frame(scene.points(), view.projection, view.framing);
  const RayExplanation ray = explain_ray(scene, camera, settings, at.x, at.y);
  for (const Output& output : outputs) write_drawing(output, draw_ray(scene, ray, drawing));
  if (o.output == "-") return exit_ok;
  if (o.json) {
    std::cout << json_text(json_of(o, ray));
  } else {
    print_text(o, ray);
  }
  return exit_ok;
}

}  // namespace

Verb add_ray(CLI::App& program) {
  CLI::App* parser = program.add_subcommand("ray", "Follow the ray through a pixel into the scene");
  const auto options = std::make_shared<RayOptions>();
  parser->add_option("IN", options->input, input_help)->required()->type_name("");
  parser->add_option("--pixel", options->pixel, "The pixel")->required()->type_name("X,Y");
  parser->add_flag("--traversal", options->traversal, "List the boxes on the way, and why each was dropped");
  parser->add_option("--depth", options->depth, "Leave out steps deeper than so many levels")->type_name("N");
  parser->add_option("-o,--output", options->output, "A picture of the boxes on the way")->type_name("FILE");
  parser->add_flag("--json", options->json, "Print JSON");
  add_accelerator_option(*parser, options->accelerator);
  options->camera.add_to(*parser);
  parser->footer(footer);
  return {parser, [options] { return run(*options); }};
}

}  // namespace velum_app
