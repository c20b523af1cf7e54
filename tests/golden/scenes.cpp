#include "scenes.hpp"

#include <set>

#include "scene_geometry.hpp"

namespace golden {
namespace {

using namespace velum;

RenderSettings sized(int width, int height, Shading shading = Shading::phong) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.shading = shading;
  return settings;
}

std::vector<std::string> every_projection() {
  std::vector<std::string> names;
  for (const ProjectionEntry& entry : projection_catalogue()) names.emplace_back(entry.name);
  return names;
}

GoldenScene entry(std::string name, Scene scene) {
  std::vector<glm::dvec3> points = scene.points();
  return {std::move(name), std::move(scene),  std::move(points),
          sized(64, 48),   Placement::around, every_projection()};
}

/// Large enough to be looked at.
GoldenScene textures() {
  GoldenScene result = entry("textured", textured());
  result.settings = sized(96, 72);
  return result;
}

/// The letter under every projection, large enough to be looked at: these are the committed pictures.
GoldenScene letter() {
  Scene scene;
  scene.add(shapes::letter_f());
  GoldenScene result = entry("letter-f", std::move(scene));
  result.settings = sized(96, 72);
  return result;
}

GoldenScene with_placement(std::string name, Scene scene, Placement placement) {
  GoldenScene result = entry(std::move(name), std::move(scene));
  result.placement = placement;
  return result;
}

/// With the six planes of the view volume; the other scenes have the guard band.
GoldenScene cut_exactly(std::string name, Scene scene, Placement placement) {
  GoldenScene result = with_placement(std::move(name), std::move(scene), placement);
  result.settings.clip = ClipPolicy::exact;
  return result;
}

GoldenScene mirrored_without_backs() {
  GoldenScene result = entry("mirrored", mirrored());
  result.settings.cull = Cull::back;
  return result;
}

GoldenScene spoilt() {
  GoldenScene result = entry("not-finite", not_finite());
  result.framed = {{-1.0, -1.0, 0.0}, {1.0, -1.0, 0.0}, {-1.0, 1.0, 0.0}, {1.0, 1.0, 0.5}, {1.0, 1.0, -0.5}};
  return result;
}

GoldenScene smoothly_lit() {
  GoldenScene result = entry("lit", lit());
  result.settings.background = {40, 44, 52, 255};
  return result;
}

GoldenScene filtered(std::string name, TextureFilter filter) {
  GoldenScene result = textures();
  result.name = std::move(name);
  result.settings.texture_filter = filter;
  result.projections = {"perspective", "isometric"};
  return result;
}

/// A plane of unit squares, 256 units deep: near ones are many pixels wide, and of those at the horizon a
/// hundred fall into each pixel.
GoldenScene horizon(std::string name, TextureFilter filter) {
  GoldenScene result =
      with_placement(std::move(name), load_scene("builtin:checkerboard"), Placement::to_horizon);
  result.settings = sized(160, 120);
  result.settings.background = {120, 160, 210, 255};
  result.settings.texture_filter = filter;
  result.projections = {"perspective"};
  return result;
}

GoldenScene large_triangles() {
  GoldenScene result = entry("large", large());
  result.settings = sized(400, 300, Shading::flat);
  return result;
}

/// The widest picture there may be. Where its row runs up the picture, hardly a pixel of it would be seen.
GoldenScene widest() {
  GoldenScene result = entry("widest", wide());
  result.settings = sized(32768, 16);
  result.projections = {"front", "top", "cabinet", "one-point"};
  return result;
}

/// With samples, with a wireframe and through glass too, and with a larger picture filtered.
void add_smooth_edges(std::vector<GoldenScene>& scenes) {
  const auto add = [&scenes](const char* name, Scene scene) -> RenderSettings& {
    scenes.push_back(entry(name, std::move(scene)));
    scenes.back().projections = {"perspective", "cabinet"};
    return scenes.back().settings;
  };
  add("samples-4", solids()).samples = 4;
  add("samples-16", transparent()).samples = 16;
  RenderSettings& wires = add("samples-wireframe", solids());
  wires.samples = 8;
  wires.wireframe = true;
  RenderSettings& fine = add("supersampled", textured());
  fine.supersample = 3;
  fine.supersample_filter = DownsampleFilter::mitchell;
}

/// The solids in every other shading.
void add_shadings(std::vector<GoldenScene>& scenes) {
  const std::pair<Shading, const char*> shadings[] = {{Shading::flat, "flat"},
                                                      {Shading::gouraud, "gouraud"},
                                                      {Shading::normal, "normal"},
                                                      {Shading::depth, "depth"},
                                                      {Shading::object_id, "object-id"},
                                                      {Shading::triangle_id, "triangle-id"},
                                                      {Shading::barycentric, "barycentric"}};
  for (const auto& [shading, name] : shadings) {
    GoldenScene scene = entry(std::string("shading-") + name, solids());
    scene.settings.shading = shading;
    scene.projections = {"perspective"};
    scenes.push_back(std::move(scene));
  }
  add_smooth_edges(scenes);
  GoldenScene wide = entry("lines", lines());
  wide.settings.line_width = 2.0f;
  scenes.push_back(std::move(wide));
  GoldenScene wires = entry("wireframe", solids());
  wires.settings.wireframe = true;
  wires.projections = {"perspective", "cabinet"};
  scenes.push_back(std::move(wires));
}

}  // namespace

std::vector<GoldenScene> golden_scenes() {
  std::vector<GoldenScene> scenes{
      letter(),
      entry("solids", solids()),
      mirrored_without_backs(),
      entry("interpenetrating", interpenetrating()),
      entry("ties", ties()),
      entry("slivers", slivers()),
      entry("sub-pixel", sub_pixel()),
      large_triangles(),
      with_placement("cut", solids(), Placement::cut),
      with_placement("inside", room(), Placement::from_inside),
      cut_exactly("cut-exact", solids(), Placement::cut),
      cut_exactly("inside-exact", room(), Placement::from_inside),
      spoilt(),
      entry("transparent", transparent()),
      textures(),
      filtered("textured-nearest", TextureFilter::nearest),
      filtered("textured-bilinear", TextureFilter::bilinear),
      horizon("horizon-nearest", TextureFilter::nearest),
      horizon("horizon-bilinear", TextureFilter::bilinear),
      horizon("horizon-trilinear", TextureFilter::trilinear),
      entry("from-text", from_text()),
      smoothly_lit(),
      entry("far-away", far_away()),
      widest(),
  };
  add_shadings(scenes);
  return scenes;
}

const std::vector<Mode>& golden_modes() {
  static const std::vector<Mode> modes{{"zbuffer", VisibilityMethod::zbuffer},
                                       {"scanline", VisibilityMethod::scanline},
                                       {"hierarchical", VisibilityMethod::hierarchical}};
  return modes;
}

bool GoldenPicture::has_file() const {
  static const std::set<std::string> only_hashed{
      "widest",    "from-text",   "shading-triangle-id", "shading-barycentric", "textured-bilinear",
      "cut-exact", "inside-exact"};
  if (only_hashed.count(scene->name) > 0) return false;
  if (scene->name == "ties") return projection == "front";  // where the ties are exact
  return scene->name == "letter-f" || projection == "perspective";
}

Camera GoldenPicture::camera() const {
  const Projection kind = parse_projection(projection);
  FrameOptions options;
  options.aspect = static_cast<double>(scene->settings.width) / scene->settings.height;
  const glm::dvec3 middle = scene->scene.bounds().centre();
  switch (scene->placement) {
    case Placement::around:
      break;
    case Placement::cut: {
      const Camera whole = frame(scene->framed, kind, options);
      const double depth = whole.far() - whole.near();
      options.near = whole.near() + 0.5 * depth;
      options.far = whole.far() - 0.1 * depth;
      break;
    }
    case Placement::from_inside:
      options.eye = middle;
      options.target = middle + kind.look;
      options.near = 0.05;
      break;
    case Placement::to_horizon:
      options.eye = glm::dvec3(middle.x + 0.3, middle.y + 1.5, scene->scene.bounds().upper.z);
      options.target = *options.eye + glm::dvec3(0.05, -0.25, -1.0);
      options.vertical_angle = radians(45.0);
      options.near = 0.5;
      break;
  }
  return frame(scene->framed, kind, options);
}

std::vector<Mode> machine_modes() {
  std::vector<Mode> modes;
  for (const Isa isa : available_isas()) {
    for (const int threads : {1, 2, 7}) {
      const std::string machine = std::string(name_of(isa)) + ", " + std::to_string(threads) + " threads";
      modes.push_back({"zbuffer, " + machine, VisibilityMethod::zbuffer, isa, threads});
      modes.push_back({"scanline, " + machine, VisibilityMethod::scanline, isa, threads});
      modes.push_back({"hierarchical, " + machine, VisibilityMethod::hierarchical, isa, threads});
    }
  }
  return modes;
}

Picture GoldenPicture::render(const Mode& mode) const {
  RenderSettings settings = scene->settings;
  settings.visibility = mode.method;
  settings.isa = mode.isa;
  settings.threads = mode.threads;
  return velum::render(scene->scene, camera(), settings);
}

std::vector<GoldenPicture> golden_pictures(const std::vector<GoldenScene>& scenes) {
  std::vector<GoldenPicture> pictures;
  for (const GoldenScene& scene : scenes) {
    for (const std::string& projection : scene.projections) pictures.push_back({&scene, projection});
  }
  return pictures;
}

}  // namespace golden
