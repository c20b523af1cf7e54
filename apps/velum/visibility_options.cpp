#include "visibility_options.hpp"

#include <filesystem>
#include <map>

namespace velum_app {
namespace {

using namespace velum;

const std::map<std::string, VisibilityMethod> method_names{{"zbuffer", VisibilityMethod::zbuffer},
                                                           {"scanline", VisibilityMethod::scanline},
                                                           {"raycast", VisibilityMethod::raycast},
                                                           {"hierarchical", VisibilityMethod::hierarchical}};
const std::map<std::string, HierarchyUse> hierarchy_names{
    {"both", HierarchyUse::both}, {"octree", HierarchyUse::octree}, {"polygons", HierarchyUse::polygons}};
const std::map<std::string, ZInterpolation> z_interpolation_names{
    {"plane", ZInterpolation::plane},
    {"edges", ZInterpolation::edges},
    {"incremental", ZInterpolation::incremental}};
const std::map<std::string, DepthFormat> depth_format_names{{"reversed", DepthFormat::reversed},
                                                            {"float", DepthFormat::float_z},
                                                            {"24", DepthFormat::z24},
                                                            {"16", DepthFormat::z16},
                                                            {"8", DepthFormat::z8}};

const std::map<std::string, ClipPolicy> clip_names{{"guard", ClipPolicy::guard},
                                                   {"exact", ClipPolicy::exact}};

std::map<std::string, AcceleratorKind> accelerator_map() {
  std::map<std::string, AcceleratorKind> names;
  for (const AcceleratorName& name : accelerator_names()) names.emplace(name.name, name.kind);
  return names;
}

std::map<std::string, Isa> isa_names() {
  std::map<std::string, Isa> names{{name_of(Isa::best), Isa::best}};
  for (const Isa isa : available_isas()) names.emplace(name_of(isa), isa);
  return names;
}

}  // namespace

void ClipOption::add_to(CLI::App& parser) {
  parser
      .add_option("--clip", policy,
                  "What cuts triangles: a guard band around the picture (default), or exact: all six planes")
      ->check(CLI::IsMember(&clip_names));
}

void ClipOption::apply_to(RenderSettings& settings) const {
  settings.clip = clip_names.at(policy);
}

CLI::Option* add_accelerator_option(CLI::App& parser, std::string& accelerator) {
  return parser
      .add_option("--accelerator", accelerator,
                  "What rays find triangles with; the answer is the same (default: bvh)")
      ->check(CLI::IsMember(accelerator_map()));
}

void VisibilityOptions::add_to(CLI::App& parser) {
  parser
      .add_option("--visibility", method,
                  "How visibility is found: zbuffer (default), scanline and hierarchical give\n"
                  "the same picture, raycast the same but for pixels that velum agree explains")
      ->check(CLI::IsMember(&method_names));
  CLI::Option* const structure = add_accelerator_option(parser, accelerator);
  accelerator_option_ = structure;
  parser
      .add_option(
          "--kd-file", kd_file,
          "With --accelerator kdtree: read the trees from FILE; where there is none, build and write it")
      ->type_name("FILE");
  CLI::Option* const analytic = parser.add_flag(
      "--analytic", is_analytic,
      "With raycast: see builtin:sphere, icosphere or cylinder by its equation, not its triangles");
  analytic->excludes(structure);
  parser
      .add_option("--hierarchical", hierarchy,
                  "With hierarchical: what the z-pyramid is asked about: octree, polygons, or both (default)")
      ->check(CLI::IsMember(&hierarchy_names));
  parser
      .add_option("--z-interpolation", z_interpolation,
                  "For teaching, with scanline: depth from the plane (default), edges, or incremental")
      ->check(CLI::IsMember(&z_interpolation_names))
      ->excludes(analytic);
  parser
      .add_option("--depth-format", depth_format,
                  "For teaching: reversed (default), float, or that many bits: 24, 16, 8")
      ->check(CLI::IsMember(&depth_format_names))
      ->excludes(analytic);
  clip.add_to(parser);
  parser.add_option("--threads", threads, "How many threads; the bytes are the same (default: 0, all)")
      ->check(CLI::Range(0, most_threads))
      ->type_name("N");
  parser
      .add_option("--isa", isa, "Which instructions of this machine; the bytes are the same (default: best)")
      ->check(CLI::IsMember(isa_names()));
}

void VisibilityOptions::check() const {
  const bool casts_rays = method_names.at(method) == VisibilityMethod::raycast;
  if (is_analytic && !casts_rays) {
    throw Error(ErrorKind::usage, "only rays ask equations", "--analytic", "add --visibility raycast");
  }
  if (hierarchy && method_names.at(method) != VisibilityMethod::hierarchical) {
    throw Error(ErrorKind::usage, "only the hierarchical method asks a z-pyramid", "--hierarchical",
                "add --visibility hierarchical");
  }
  const bool is_chosen = accelerator_option_ != nullptr && accelerator_option_->count() > 0;
  if (is_chosen && !casts_rays) {
    throw Error(ErrorKind::usage, "only rays are helped by it", "--accelerator", "add --visibility raycast");
  }
  if (!kd_file) return;
  const bool uses_trees = casts_rays && !is_analytic && accelerator == "kdtree";
  if (!uses_trees || *kd_file == "-") {
    throw Error(ErrorKind::usage, uses_trees ? "the trees need a file of their own" : "no kd-tree is used",
                "--kd-file", "give a file name, and --visibility raycast --accelerator kdtree");
  }
}

void VisibilityOptions::prepare_trees(const Scene& scene, RenderSettings& settings) const {
  if (!kd_file) return;
  if (std::filesystem::exists(*kd_file)) {
    settings.caster = load_kd_trees(*kd_file, scene);
    return;
  }
  settings.caster = std::make_shared<SceneCaster>(scene, AcceleratorKind::kd_tree, settings.isa);
  save_kd_trees(*kd_file, *settings.caster);
}

void VisibilityOptions::apply_to(RenderSettings& settings) const {
  settings.visibility = method_names.at(method);
  check();
  settings.accelerator = accelerator_map().at(accelerator);
  settings.hierarchy.use = hierarchy_names.at(hierarchy.value_or("both"));
  settings.z_interpolation = z_interpolation_names.at(z_interpolation);
  settings.depth_format = depth_format_names.at(depth_format);
  clip.apply_to(settings);
  settings.threads = threads;
  settings.isa = isa_names().at(isa);
}

}  // namespace velum_app
