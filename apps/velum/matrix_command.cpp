// velum matrix: the composite viewing matrix, stage by stage, and the way of a point through it.
#include <glm/geometric.hpp>
#include <iostream>
#include <memory>
#include <velum/projection/viewport.hpp>
#include <velum/velum.hpp>

#include "camera_options.hpp"
#include "json_values.hpp"
#include "matrix_text.hpp"
#include "text.hpp"
#include "verb.hpp"

namespace velum_app {
namespace {

using namespace velum;

struct MatrixOptions {
  CameraOptions camera;
  std::optional<std::string> point;
  bool json = false;
};

constexpr const char* description = "Show the viewing matrix stage by stage, and what it does to a point";
constexpr const char* footer =
    "There is no scene here: what the options leave open is framed for the cube of edge 1 around the "
    "origin.\n"
    "Examples:\n"
    "  velum matrix --projection isometric\n"
    "  velum matrix --projection cabinet --point 0.5,0.5,0.5\n"
    "  velum matrix --eye 0,0,5 --target 0,0,0 --fov 45 --near 1 --far 10 --point 1,1,1 --json";

/// The cube that stands for the scene.
Aabb unit_cube() {
  return {glm::dvec3(-0.5), glm::dvec3(0.5)};
}

/// What becomes of a point: its images after each stage, the divide and the pixel.
struct PointPath {
  std::vector<glm::dvec4> images;  ///< the point itself first
  glm::dvec4 ndc{0.0};             ///< after the divide; only where w > 0
  glm::dvec2 pixel{0.0};
  Outcode code = 0;

  bool is_in_front_of_eye() const { return images.back().w > 0.0; }
};

PointPath path_of(const glm::dvec3& point, const ViewingTransform& transform, const Size& size) {
  PointPath path;
  path.images = transform.images_of(glm::dvec4(point, 1.0));
  const glm::dvec4 clip = path.images.back();
  path.code = outcode(clip);
  if (path.is_in_front_of_eye()) {
    path.ndc = clip / clip.w;
    path.pixel = Viewport{size.width, size.height}.pixel_from_ndc(path.ndc.x, path.ndc.y);
  }
  return path;
}

/// The planes that the point is outside of: ["left", "above"].
Json outside_json(Outcode code) {
  Json list = Json::array();
  for (int i = 0; i < clip_plane_count; ++i) {
    if ((code >> i) & 1) list.push_back(clip_planes[static_cast<std::size_t>(i)].name);
  }
  return list;
}

std::string outside_text(Outcode code) {
  if (code == 0) return "inside the view volume";
  std::string text;
  for (const Json& name : outside_json(code))
    text += (text.empty() ? "outside: " : ", ") + name.get<std::string>();
  return text;
}

Json path_json(const PointPath& path) {
  Json images = Json::array();
  for (const glm::dvec4& image : path.images) images.push_back(json_of(image));
  Json json{{"images", images}, {"outside", outside_json(path.code)}, {"ndc", nullptr}, {"pixel", nullptr}};
  if (path.is_in_front_of_eye()) {
    json["ndc"] = json_of(glm::dvec3(path.ndc));
    json["pixel"] = Json::array({path.pixel.x, path.pixel.y});
  }
  return json;
}

void print_path(const PointPath& path, const ViewingTransform& transform) {
  const StageList& stages = transform.stages();
  std::size_t width = 16;
  for (const Stage& stage : stages) width = std::max(width, text_width(std::string(stage.name)) + 6);
  std::cout << "\nThe way of the point\n";
  const auto line = [width](const std::string& name, const std::string& value) {
    std::cout << "  " << padded_right(name, width) << "  " << value << '\n';
  };
  line("world", vector_text(path.images[0]));
  for (std::size_t i = 0; i < stages.size(); ++i)
    line("after " + std::string(stages[i].name), vector_text(path.images[i + 1]));
  if (path.is_in_front_of_eye()) {
    line("after the divide", vector_text(path.ndc));
    line("pixel", "(" + fixed_text(path.pixel.x, 3) + ", " + fixed_text(path.pixel.y, 3) + ")");
  } else {
    line("after the divide", "none: w is not positive, the point is not in front of the camera");
  }
  line("outcode", outside_text(path.code));
}

void print_text(const View& view, const ViewingTransform& transform, const std::optional<PointPath>& path) {
  std::cout << "Projection " << view.projection.name << ", picture " << view.size.width << 'x'
            << view.size.height << "; column vectors, stages in the order of application\n";
  int number = 0;
  for (const Stage& stage : transform.stages()) {
    std::cout << '\n'
              << ++number << ". " << stage.name << ": " << stage.meaning << '\n'
              << matrix_text(stage.matrix);
  }
  std::cout << "\nProduct (clip from world): all stages, the last one leftmost\n"
            << matrix_text(transform.clip_from_world());
  if (path) print_path(*path, transform);
}

int run(const MatrixOptions& o) {
  const View view = view_from(o.camera);
  std::optional<glm::dvec3> point;
  if (o.point) point = vector_from(*o.point, "--point");
  const Camera camera = frame(unit_cube(), view.projection, view.framing);
  const ViewingTransform transform = camera.viewing_transform(view.framing.aspect);
  std::optional<PointPath> path;
  if (point) path = path_of(*point, transform, view.size);
  if (!o.json) {
    print_text(view, transform, path);
    return exit_ok;
  }
  Json json{{"projection", view.projection.name},
            {"size", Json::array({view.size.width, view.size.height})},
            {"camera", json_of(camera)},
            {"stages", json_of(transform.stages())},
            {"product", json_of(transform.clip_from_world())}};
  if (path) json["point"] = path_json(*path);
  std::cout << json_text(json);
  return exit_ok;
}

}  // namespace

Verb add_matrix(CLI::App& program) {
  CLI::App* parser = program.add_subcommand("matrix", description);
  const auto options = std::make_shared<MatrixOptions>();
  options->camera.add_to(*parser);
  parser->add_option("--point", options->point, "A world point to follow through the stages")
      ->type_name("X,Y,Z");
  parser->add_flag("--json", options->json, "Print JSON");
  parser->footer(footer);
  return {parser, [options] { return run(*options); }};
}

}  // namespace velum_app
