// velum info IN: what is in a mesh file.
#include <iostream>
#include <memory>
#include <velum/velum.hpp>

#include "input.hpp"
#include "json_values.hpp"
#include "mesh_facts.hpp"
#include "text.hpp"
#include "verb.hpp"

namespace velum_app {
namespace {

using namespace velum;

struct InfoOptions {
  std::string input;
  bool json = false;
};

constexpr const char* footer =
    "Examples:\n"
    "  velum info bunny.obj\n"
    "  velum info builtin:torus --json";

/// What a person should know of a mesh, one remark per line.
std::vector<std::string> notes_on(const Mesh& mesh, const MeshFacts& facts) {
  std::vector<std::string> notes;
  const auto note = [&notes](std::uint64_t count, const std::string& noun, const std::string& text) {
    if (count > 0) notes.push_back(counted_text(count, noun) + " " + text);
  };
  if (mesh.primitive_count() == 0) notes.push_back("no triangles, segments or points");
  note(facts.boundary_edges, "edge", "with a triangle on one side only: the surface is open");
  note(facts.irregular_edges, "edge", "where triangles meet irregularly");
  note(facts.zero_area, "triangle", "without area");
  note(facts.not_finite, "vertex position", "not finite");
  note(facts.skipped, "triangle", "with a position that is not finite: not drawn");
  return notes;
}

std::string point_text(const glm::dvec3& p) {
  return "(" + number_text(p.x) + ", " + number_text(p.y) + ", " + number_text(p.z) + ")";
}

std::string attributes_of(const Mesh& mesh) {
  std::string text;
  const auto add = [&text](bool present, const char* name) {
    if (present) text += std::string(text.empty() ? "" : ", ") + name;
  };
  add(!mesh.normals.empty(), "normals");
  add(!mesh.texture_coordinates.empty(), "texture coordinates");
  add(!mesh.colours.empty(), "colours");
  return text;
}

std::uint64_t vertex_count(const Scene& scene) {
  std::uint64_t count = 0;
  for (const Mesh& mesh : scene.meshes()) count += mesh.positions.size();
  return count;
}

std::uint64_t triangle_count(const Scene& scene) {
  std::uint64_t count = 0;
  for (const Instance& i : scene.instances()) count += scene.meshes()[i.mesh].triangles.size();
  return count;
}

std::string primitives_of(const Scene& scene) {
  std::uint64_t segments = 0, points = 0;
  for (const Instance& i : scene.instances()) {
    segments += scene.meshes()[i.mesh].segments.size();
    points += scene.meshes()[i.mesh].points.size();
  }
  return primitives_text(triangle_count(scene), segments, points);
}

Json bounds_json(const Aabb& box) {
  if (box.is_empty()) return nullptr;
  return {{"lower", json_of(box.lower)}, {"upper", json_of(box.upper)}};
}

Json mesh_json(const Mesh& mesh) {
  const MeshFacts facts = facts_of(mesh);
  return {{"name", mesh.name},
          {"vertices", mesh.positions.size()},
          {"triangles", mesh.triangles.size()},
          {"segments", mesh.segments.size()},
          {"points", mesh.points.size()},
          {"normals", !mesh.normals.empty()},
          {"texture_coordinates", !mesh.texture_coordinates.empty()},
          {"colours", !mesh.colours.empty()},
          {"bounds", bounds_json(bounds(mesh))},
          {"closed", facts.is_closed()},
          {"distinct_positions", facts.welded_vertices},
          {"boundary_edges", facts.boundary_edges},
          {"irregular_edges", facts.irregular_edges},
          {"triangles_without_area", facts.zero_area},
          {"triangles_not_finite", facts.skipped},
          {"notes", notes_on(mesh, facts)}};
}

Json scene_json(const std::string& input, const Scene& scene) {
  Json meshes = Json::array();
  for (const Mesh& mesh : scene.meshes()) meshes.push_back(mesh_json(mesh));
  Json instances = Json::array();
  for (const Instance& i : scene.instances()) {
    instances.push_back({{"name", i.name}, {"mesh", i.mesh}, {"material", i.material}});
  }
  Json materials = Json::array();
  for (const Material& m : scene.materials()) {
    materials.push_back({{"name", m.name},
                         {"base_colour", json_of(glm::dvec3(m.base_colour))},
                         {"base_colour_texture", m.base_colour_texture},
                         {"shininess", m.shininess},
                         {"alpha", m.alpha}});
  }
  return {{"input", input},
          {"vertices", vertex_count(scene)},
          {"primitives", scene.primitive_count()},
          {"triangles", triangle_count(scene)},
          {"bounds", bounds_json(scene.bounds())},
          {"meshes", meshes},
          {"instances", instances},
          {"materials", materials},
          {"notes", scene.notes}};
}

void print_mesh(const Mesh& mesh) {
  const MeshFacts facts = facts_of(mesh);
  const std::string attributes = attributes_of(mesh);
  std::cout << "  mesh \"" << mesh.name << "\": " << grouped_text(mesh.positions.size()) << " vertices, "
            << primitives_text(mesh.triangles.size(), mesh.segments.size(), mesh.points.size())
            << (attributes.empty() ? "" : ", with ") << attributes << (facts.is_closed() ? ", closed" : "")
            << '\n';
  for (const std::string& note : notes_on(mesh, facts)) std::cout << "    note: " << note << '\n';
}

void print_text(const std::string& input, const Scene& scene) {
  const Aabb box = scene.bounds();
  std::cout << input << ": " << primitives_of(scene) << ", " << grouped_text(vertex_count(scene))
            << " vertices, " << counted_text(scene.instances().size(), "instance") << ", "
            << counted_text(scene.materials().size(), "material") << '\n';
  if (box.is_empty()) {
    std::cout << "  bounds: none\n";
  } else {
    std::cout << "  bounds: " << point_text(box.lower) << " to " << point_text(box.upper) << ", size "
              << point_text(box.size()) << '\n';
  }
  for (const std::string& note : scene.notes) std::cout << "  note: " << note << '\n';
  for (const Mesh& mesh : scene.meshes()) print_mesh(mesh);
  for (const Material& m : scene.materials()) {
    std::cout << "  material \"" << (m.name.empty() ? "default" : m.name) << "\": base colour (linear) "
              << point_text(glm::dvec3(m.base_colour)) << ", alpha "
              << number_text(static_cast<double>(m.alpha));
    if (!m.base_colour_texture.empty()) std::cout << ", texture " << m.base_colour_texture;
    std::cout << '\n';
  }
}

int run(const InfoOptions& o) {
  const Scene scene = read_scene(o.input);
  if (o.json) {
    std::cout << json_text(scene_json(o.input, scene));
  } else {
    print_text(o.input, scene);
  }
  return exit_ok;
}

}  // namespace

Verb add_info(CLI::App& program) {
  CLI::App* parser = program.add_subcommand("info", "Tell what is in a mesh file");
  const auto options = std::make_shared<InfoOptions>();
  parser->add_option("IN", options->input, input_help)->required()->type_name("");
  parser->add_flag("--json", options->json, "Print JSON");
  parser->footer(footer);
  return {parser, [options] { return run(*options); }};
}

}  // namespace velum_app
