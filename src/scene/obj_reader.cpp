#include "obj_reader.hpp"

#include <numeric>
#include <set>

#include "../base/error.hpp"
#include "../image/files.hpp"
#include "key_table.hpp"
#include "memory_bound.hpp"
#include "missing_normals.hpp"
#include "mtl_reader.hpp"
#include "obj_statements.hpp"
#include "text_scanner.hpp"
#include "triangulate.hpp"
#include "vertex_colours.hpp"

namespace velum {
namespace {

constexpr std::uint32_t no_index = ObjCorner::no_index;

// Builds the scene from the statements; consumes them on the way, to keep the memory low.
class ObjBuilder {
 public:
  ObjBuilder(ObjStatements statements, const std::string& name, std::size_t file_bytes,
             const LoadOptions& options)
      : in_(std::move(statements)), name_(name), file_bytes_(file_bytes), options_(options) {}

  void read_libraries(const std::filesystem::path& directory);
  Scene build();

 private:
  // A run's triangles.
  struct Piece {
    std::size_t first_triangle;
    std::size_t end_triangle;
  };

  void read_library(const std::filesystem::path& path);
  void tell_of_libraries(const std::string& what, std::size_t count, const std::string& first);
  void triangulate();
  void complete_normals();
  bool has_normal(const ObjCorner& corner) const;
  bool lacks_normals() const;
  void append_smooth_normals();
  void append_flat_normals();
  glm::uvec3 key(std::size_t triangle, int corner) const;
  Mesh mesh(const Piece& piece, std::string mesh_name) const;
  Mesh vertices_as_points() const;
  Mesh lines(std::size_t run, std::string mesh_name) const;
  void add(Mesh mesh, std::string_view material_name, Scene& scene);
  std::uint32_t material(std::string_view material_name, Scene& scene);

  ObjStatements in_;
  const std::string& name_;
  std::size_t file_bytes_;
  LoadOptions options_;
  MaterialLibrary library_;
  std::unordered_map<std::string, std::uint32_t> materials_;  // places in the scene
  std::vector<glm::uvec3> triangles_;                         // places in in_.corners
  std::vector<Piece> pieces_;                                 // one per run
  std::size_t file_normals_ = 0;  // in_.normals: the file's, then the computed ones
};

void ObjBuilder::read_libraries(const std::filesystem::path& directory) {
  std::set<std::filesystem::path> seen;
  std::size_t missing = 0, broken = 0;
  std::string first_missing, first_fault;
  const auto read_once = [&](std::string_view named) {
    std::error_code ignored;
    if (directory.empty() || named.empty()) return false;
    const std::filesystem::path path = beside(directory, named);
    if (!std::filesystem::is_regular_file(path, ignored)) return false;
    if (!seen.insert(path.lexically_normal()).second) return true;
    try {
      read_library(path);
    } catch (const Error& error) {  // the mesh is worth more than its colours
      if (broken++ == 0) first_fault = error.what();
    }
    return true;
  };
  for (const std::string_view names : in_.libraries) {
    // One name that may hold blanks, as most programs write it; else several names, as the manual has it.
    if (read_once(names)) continue;
    TextScanner list(names, name_);
    for (std::string_view one = list.token(); !one.empty(); one = list.token()) {
      if (!read_once(one) && missing++ == 0) first_missing = quoted(one);
    }
  }
  tell_of_libraries("not found beside the file, the first is ", missing, first_missing);
  tell_of_libraries("read only as far as a fault, the first is ", broken, first_fault);
}

void ObjBuilder::read_library(const std::filesystem::path& path) {
  const std::vector<std::byte> bytes = read_file(path);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  read_mtl(text, path.string(), path.parent_path(), library_, in_.notes);
}

void ObjBuilder::tell_of_libraries(const std::string& what, std::size_t count, const std::string& first) {
  if (count == 0) return;
  in_.notes.push_back(std::to_string(count) +
                      (count == 1 ? " material library is " : " material libraries are ") + what + first +
                      "; their materials are the default one");
}

void ObjBuilder::triangulate() {
  std::size_t count = 0;
  for (const ObjPolygon& polygon : in_.polygons) count += polygon.corner_count - 2;
  triangles_.reserve(count);
  Triangulator triangulator(Triangulator::steps_for(file_bytes_));
  std::string first_fan;
  std::vector<glm::vec3> outline;
  std::size_t first = 0, run = 0;
  for (std::size_t i = 0; i < in_.polygons.size(); ++i) {
    for (; run < in_.runs.size() && in_.runs[run].first_polygon == i; ++run)
      pieces_.push_back({triangles_.size(), 0});
    const ObjPolygon& polygon = in_.polygons[i];
    outline.clear();
    for (std::size_t c = first; c < first + polygon.corner_count; ++c) {
      outline.push_back(in_.positions[in_.corners[c].position]);
    }
    const std::size_t before = triangles_.size();
    if (!triangulator.triangulate(outline, triangles_)) {
      throw Error(ErrorKind::read,
                  "a concave polygon with " + std::to_string(polygon.corner_count) + " corners, more than " +
                      std::to_string(Triangulator::most_concave_corners),
                  name_ + ":" + std::to_string(polygon.line), "triangulate it in the program it comes from");
    }
    if (triangulator.fan_count() == 1 && first_fan.empty())
      first_fan = "in line " + std::to_string(polygon.line);
    for (std::size_t t = before; t < triangles_.size(); ++t)
      triangles_[t] += static_cast<std::uint32_t>(first);
    first += polygon.corner_count;
  }
  if (!first_fan.empty()) in_.notes.push_back(triangulator.note_on_fans(first_fan));
  for (; run < in_.runs.size(); ++run) pieces_.push_back({triangles_.size(), 0});
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    pieces_[i].end_triangle = i + 1 < pieces_.size() ? pieces_[i + 1].first_triangle : triangles_.size();
  }
}

bool ObjBuilder::has_normal(const ObjCorner& corner) const {
  return corner.normal != no_index && in_.normals[corner.normal] != glm::vec3(0.0f);
}

bool ObjBuilder::lacks_normals() const {
  for (const ObjCorner& corner : in_.corners) {
    if (!has_normal(corner)) return true;
  }
  return false;
}

void ObjBuilder::complete_normals() {
  for (glm::vec3& normal : in_.normals) normal = unit_or_zero(normal);
  file_normals_ = in_.normals.size();
  if (!lacks_normals()) return;
  if (options_.missing_normals == MissingNormals::smooth)
    append_smooth_normals();
  else
    append_flat_normals();
}

// One per position, over all faces of the file: no seam where the material or the texture changes.
void ObjBuilder::append_smooth_normals() {
  std::vector<glm::uvec3> triangles(triangles_);
  for (glm::uvec3& triangle : triangles) {
    for (int i = 0; i < 3; ++i) triangle[i] = in_.corners[triangle[i]].position;
  }
  Mesh whole;
  whole.positions = Array<glm::vec3>::viewing(in_.positions);
  whole.triangles = std::move(triangles);
  const std::vector<glm::vec3> smooth = smooth_normals(whole);
  in_.normals.insert(in_.normals.end(), smooth.begin(), smooth.end());
}

// One per triangle. Then no two triangles share a vertex, which is what takes the memory.
void ObjBuilder::append_flat_normals() {
  constexpr std::size_t bytes_per_triangle = 300;
  require_within_memory_bound(triangles_.size() * bytes_per_triangle, file_bytes_,
                              "the triangles with flat normals", name_);
  in_.normals.reserve(file_normals_ + triangles_.size());
  for (const glm::uvec3& triangle : triangles_) {
    glm::vec3 p[3];
    for (int i = 0; i < 3; ++i) p[i] = in_.positions[in_.corners[triangle[i]].position];
    const glm::vec3 normal = face_normal(p[0], p[1], p[2]);
    in_.normals.push_back(normal == glm::vec3(0.0f) ? glm::vec3(0.0f, 0.0f, 1.0f) : normal);
  }
}

// What makes two vertices the same: the places of position, texture coordinate and normal.
glm::uvec3 ObjBuilder::key(std::size_t triangle, int corner_number) const {
  const ObjCorner& corner = in_.corners[triangles_[triangle][corner_number]];
  const bool is_smooth = options_.missing_normals == MissingNormals::smooth;
  const std::size_t computed = file_normals_ + (is_smooth ? corner.position : triangle);
  return {corner.position, corner.texture,
          has_normal(corner) ? corner.normal : static_cast<std::uint32_t>(computed)};
}

Mesh ObjBuilder::mesh(const Piece& piece, std::string mesh_name) const {
  KeyTable vertices;
  std::vector<glm::uvec3> triangles(piece.end_triangle - piece.first_triangle);
  bool is_textured = false;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const glm::uvec3 vertex = key(piece.first_triangle + t, i);
      is_textured = is_textured || vertex.y != no_index;
      triangles[t][i] = vertices.number_of(vertex);
    }
  }
  const std::size_t count = vertices.keys().size();
  std::vector<glm::vec3> positions(count), normals(count);
  std::vector<glm::vec2> texture_coordinates(is_textured ? count : 0);
  std::vector<glm::vec4> colours(in_.colours.empty() ? 0 : count);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::uvec3& vertex = vertices.keys()[i];
    positions[i] = in_.positions[vertex.x];
    normals[i] = in_.normals[vertex.z];
    if (is_textured && vertex.y != no_index) texture_coordinates[i] = in_.texture_coordinates[vertex.y];
    if (!colours.empty()) colours[i] = in_.colours[vertex.x];
  }
  Mesh result;
  result.name = std::move(mesh_name);
  result.positions = std::move(positions);
  result.normals = std::move(normals);
  if (is_textured) result.texture_coordinates = std::move(texture_coordinates);
  if (!colours.empty()) result.colours = std::move(colours);
  result.triangles = std::move(triangles);
  return result;
}

// The segments and points of a run: a mesh of their own, without normals, so that they are not lit.
Mesh ObjBuilder::lines(std::size_t run, std::string mesh_name) const {
  const bool is_last = run + 1 == in_.runs.size();
  const std::size_t last_segment = is_last ? in_.segments.size() : in_.runs[run + 1].first_segment;
  const std::size_t last_point = is_last ? in_.points.size() : in_.runs[run + 1].first_point;
  KeyTable vertices;
  const auto number_of = [&](std::uint32_t position) { return vertices.number_of({position, 0u, 0u}); };
  std::vector<glm::uvec2> segments;
  std::vector<std::uint32_t> points;
  for (std::size_t i = in_.runs[run].first_segment; i < last_segment; ++i) {
    const std::uint32_t from = number_of(in_.segments[i].x);
    segments.emplace_back(from, number_of(in_.segments[i].y));
  }
  for (std::size_t i = in_.runs[run].first_point; i < last_point; ++i)
    points.push_back(number_of(in_.points[i]));
  std::vector<glm::vec3> positions;
  std::vector<glm::vec4> colours;
  for (const glm::uvec3& key : vertices.keys()) {
    positions.push_back(in_.positions[key.x]);
    if (!in_.colours.empty()) colours.push_back(in_.colours[key.x]);
  }
  Mesh result;
  result.name = std::move(mesh_name);
  result.positions = std::move(positions);
  if (!colours.empty()) result.colours = std::move(colours);
  result.segments = std::move(segments);
  result.points = std::move(points);
  return result;
}

Mesh ObjBuilder::vertices_as_points() const {
  Mesh result;
  result.name = std::filesystem::path(name_).stem().string();
  result.positions = in_.positions;
  if (!in_.colours.empty()) result.colours = in_.colours;
  std::vector<std::uint32_t> points(in_.positions.size());
  std::iota(points.begin(), points.end(), 0u);
  result.points = std::move(points);
  return result;
}

std::uint32_t ObjBuilder::material(std::string_view material_name, Scene& scene) {
  if (material_name.empty()) return 0;
  const auto [place, is_new] = materials_.try_emplace(std::string(material_name), 0u);
  if (!is_new) return place->second;
  const auto found = library_.find(place->first);
  Material result = found != library_.end() ? found->second : Material{};
  if (found == library_.end()) {
    result.name = place->first;
    if (!library_.empty()) in_.notes.push_back("no library has the material " + quoted(material_name));
  }
  return place->second = scene.add_material(std::move(result));
}

void ObjBuilder::add(Mesh mesh, std::string_view material_name, Scene& scene) {
  Instance instance;
  instance.name = mesh.name;
  instance.mesh = scene.add_mesh(std::move(mesh));
  instance.material = material(material_name, scene);
  scene.add_instance(std::move(instance));
}

Scene ObjBuilder::build() {
  Scene scene;
  triangulate();
  note_positions_not_finite(in_.positions, in_.notes);
  complete_normals();
  const std::string stem = std::filesystem::path(name_).stem().string();
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const ObjRun& run = in_.runs[i];
    const std::string object = run.object.empty() ? stem : std::string(run.object);
    if (pieces_[i].first_triangle < pieces_[i].end_triangle)
      add(mesh(pieces_[i], object), run.material, scene);
    Mesh line_mesh = lines(i, object);
    if (line_mesh.primitive_count() > 0) add(std::move(line_mesh), run.material, scene);
  }
  if (in_.positions.empty()) {
    in_.notes.push_back("the file has no vertices, there is nothing to draw");
  } else if (in_.runs.empty()) {
    in_.notes.push_back("the file has no faces: its vertices are drawn as points");
    scene.add(vertices_as_points());
  }
  if (!in_.colours.empty()) show_vertex_colours(scene);
  scene.notes = std::move(in_.notes);
  return scene;
}

}  // namespace

Scene read_obj(std::string_view text, const std::string& name, const std::filesystem::path& directory,
               const LoadOptions& options) {
  ObjBuilder builder(read_obj_statements(text, name), name, text.size(), options);
  builder.read_libraries(directory);
  return builder.build();
}

}  // namespace velum
