#include "ply_reader.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "../base/error.hpp"
#include "../image/colour.hpp"
#include "file_colours.hpp"
#include "missing_normals.hpp"
#include "ply_header.hpp"
#include "ply_values.hpp"
#include "triangulate.hpp"
#include "vertex_colours.hpp"

namespace velum {
namespace {

class PlyParser {
 public:
  PlyParser(std::span<const std::byte> bytes, const std::string& name)
      : header_(read_ply_header({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, name)),
        values_(bytes, header_, name),
        name_(name),
        file_bytes_(bytes.size()) {}

  Scene parse(const LoadOptions& options);

 private:
  // Of a vertex: its values by role.
  using Values = std::array<float, ply_role_count>;

  bool has(const PlyElement& element, PlyRole role) const;
  bool has(const PlyElement& element, std::initializer_list<PlyRole> roles) const;
  void require_elements(const PlyElement& element) const;
  void element(const PlyElement& element);
  void skip(const PlyElement& element);
  void skip(const PlyProperty& property);
  std::uint64_t list_length(const PlyProperty& property);
  void vertices(const PlyElement& element);
  void vertex(const PlyElement& element, Values& values);
  float colour(PlyType type, PlyRole role);
  void faces(const PlyElement& element);
  void strips(const PlyElement& element);
  void edges(const PlyElement& element);
  std::uint32_t vertex_index(PlyType type);
  [[noreturn]] void fail_index(std::int64_t index);
  void corners(const PlyProperty& property, std::vector<std::uint32_t>& out);
  void triangulate();
  Mesh vertex_mesh();
  void add_faces(const Mesh& vertices, const LoadOptions& options, Scene& scene);
  void add_lines(const Mesh& vertices, Scene& scene);

  PlyHeader header_;
  PlyValues values_;
  const std::string& name_;
  std::size_t file_bytes_;
  const PlyElement* vertex_element_ = nullptr;
  std::uint64_t vertex_count_ = 0;  // as announced: faces may come first
  std::vector<glm::vec3> positions_, normals_;
  std::vector<glm::vec2> texture_coordinates_;
  std::vector<glm::vec4> colours_;
  std::vector<std::uint32_t> corners_;        // of all faces
  std::vector<std::uint32_t> corner_counts_;  // one per face
  std::vector<glm::uvec3> triangles_;
  std::vector<glm::uvec2> segments_;
  std::vector<std::string> notes_;
};

bool PlyParser::has(const PlyElement& element, PlyRole role) const {
  for (const PlyProperty& property : element.properties) {
    if (property.role == role) return true;
  }
  return false;
}

bool PlyParser::has(const PlyElement& element, std::initializer_list<PlyRole> roles) const {
  for (const PlyRole role : roles) {
    if (!has(element, role)) return false;
  }
  return true;
}

Scene PlyParser::parse(const LoadOptions& options) {
  for (const PlyElement& e : header_.elements) {
    if (e.name != "vertex" || vertex_element_ != nullptr) continue;
    vertex_element_ = &e;
    vertex_count_ = e.count;
  }
  for (const PlyElement& e : header_.elements) element(e);
  triangulate();
  note_positions_not_finite(positions_, notes_);
  Scene scene;
  if (positions_.empty()) {
    notes_.push_back("the file has no vertices, there is nothing to draw");
  } else {
    const Mesh vertices = vertex_mesh();
    add_faces(vertices, options, scene);
    add_lines(vertices, scene);
    if (!vertices.colours.empty()) show_vertex_colours(scene);
  }
  scene.notes = std::move(notes_);
  return scene;
}

// The vertices alone; meshes made of it share its arrays.
Mesh PlyParser::vertex_mesh() {
  Mesh mesh;
  mesh.name = std::filesystem::path(name_).stem().string();
  mesh.positions = std::move(positions_);
  if (!normals_.empty()) mesh.normals = std::move(normals_);
  if (!texture_coordinates_.empty()) mesh.texture_coordinates = std::move(texture_coordinates_);
  if (!colours_.empty()) mesh.colours = std::move(colours_);
  return mesh;
}

void PlyParser::add_faces(const Mesh& vertices, const LoadOptions& options, Scene& scene) {
  if (triangles_.empty()) return;
  Mesh mesh = vertices;
  mesh.triangles = std::move(triangles_);
  scene.add(with_complete_normals(std::move(mesh), options.missing_normals, file_bytes_, name_));
}

// A mesh of their own: segments and points have no face to take a missing normal from, and stay unlit.
void PlyParser::add_lines(const Mesh& vertices, Scene& scene) {
  if (segments_.empty() && !scene.meshes().empty()) return;
  Mesh mesh = vertices;
  if (segments_.empty()) {
    std::vector<std::uint32_t> points(mesh.positions.size());
    std::iota(points.begin(), points.end(), 0u);
    mesh.points = std::move(points);
  } else {
    mesh.segments = std::move(segments_);
  }
  std::vector<glm::vec3> normals(mesh.normals.begin(), mesh.normals.end());
  for (glm::vec3& normal : normals) normal = unit_or_zero(normal);
  if (!normals.empty()) mesh.normals = std::move(normals);
  scene.add(std::move(mesh));
}

// Every value takes at least a byte, so that a count is bounded by the file before anything is reserved.
void PlyParser::require_elements(const PlyElement& element) const {
  std::size_t least = 0;
  for (const PlyProperty& property : element.properties) {
    least += values_.least_size(property.is_list ? property.count_type : property.type);
  }
  const std::string what = "elements " + quoted(element.name);
  values_.require(element.count, least, what.c_str());
}

void PlyParser::element(const PlyElement& element) {
  require_elements(element);
  if (&element == vertex_element_)
    vertices(element);
  else if (element.name == "face" && has(element, PlyRole::corners))
    faces(element);
  else if (element.name == "tristrips" && has(element, PlyRole::corners))
    strips(element);
  else if (element.name == "edge" && has(element, {PlyRole::vertex1, PlyRole::vertex2}))
    edges(element);
  else
    skip(element);
}

void PlyParser::skip(const PlyElement& element) {
  if (element.count == 0 || element.properties.empty()) return;
  notes_.push_back(std::to_string(element.count) + " elements " + quoted(element.name) + " are left out");
  for (std::uint64_t i = 0; i < element.count; ++i) {
    for (const PlyProperty& property : element.properties) skip(property);
  }
}

void PlyParser::skip(const PlyProperty& property) {
  const std::uint64_t count = property.is_list ? list_length(property) : 1;
  for (std::uint64_t i = 0; i < count; ++i) values_.skip(property.type);
}

std::uint64_t PlyParser::list_length(const PlyProperty& property) {
  const std::int64_t length = values_.integer(property.count_type);
  if (length < 0) values_.fail("a list of negative length");
  values_.require(static_cast<std::uint64_t>(length), values_.least_size(property.type), "list entries");
  return static_cast<std::uint64_t>(length);
}

void PlyParser::vertices(const PlyElement& element) {
  if (!has(element, {PlyRole::x, PlyRole::y, PlyRole::z})) {
    throw Error(ErrorKind::read, "the vertices lack x, y or z", name_, "export the file with positions");
  }
  if (element.count > 0x7FFFFFFFu) values_.fail("more than 2,147,483,647 vertices", "split the file");
  const bool has_normals = has(element, {PlyRole::nx, PlyRole::ny, PlyRole::nz});
  const bool has_colours = has(element, {PlyRole::red, PlyRole::green, PlyRole::blue});
  const bool has_texture = has(element, {PlyRole::u, PlyRole::v});
  const auto count = static_cast<std::size_t>(element.count);
  positions_.reserve(count);
  normals_.reserve(has_normals ? count : 0);
  colours_.reserve(has_colours ? count : 0);
  texture_coordinates_.reserve(has_texture ? count : 0);
  Values values{};
  values[static_cast<std::size_t>(PlyRole::alpha)] = 1.0f;
  const auto value = [&](PlyRole role) { return values[static_cast<std::size_t>(role)]; };
  for (std::size_t i = 0; i < count; ++i) {
    vertex(element, values);
    positions_.emplace_back(value(PlyRole::x), value(PlyRole::y), value(PlyRole::z));
    if (has_normals) normals_.emplace_back(value(PlyRole::nx), value(PlyRole::ny), value(PlyRole::nz));
    if (has_colours) {
      colours_.emplace_back(value(PlyRole::red), value(PlyRole::green), value(PlyRole::blue),
                            value(PlyRole::alpha));
    }
    if (has_texture) texture_coordinates_.emplace_back(value(PlyRole::u), value(PlyRole::v));
  }
}

void PlyParser::vertex(const PlyElement& element, Values& values) {
  for (const PlyProperty& property : element.properties) {
    if (property.role == PlyRole::none) {
      skip(property);
    } else {
      const bool is_colour = property.role >= PlyRole::red && property.role <= PlyRole::alpha;
      values[static_cast<std::size_t>(property.role)] =
          is_colour ? colour(property.type, property.role) : values_.real(property.type);
    }
  }
}

// Whole types hold sRGB codes, 0…65535 in 16 unsigned bits and 0…255 otherwise; real ones are linear. Alpha
// is never encoded.
float PlyParser::colour(PlyType type, PlyRole role) {
  if (is_real(type)) return values_.real(type);
  const std::int64_t largest = type == PlyType::uint16 ? 65535 : 255;
  const std::int64_t code = std::min(std::max<std::int64_t>(values_.integer(type), 0), largest);
  if (role == PlyRole::alpha) return static_cast<float>(code) / static_cast<float>(largest);
  if (largest == 255) return linear_from_srgb(static_cast<std::uint8_t>(code));
  return linear_from_srgb_value(static_cast<double>(code) / 65535.0);
}

void PlyParser::fail_index(std::int64_t index) {
  values_.fail("vertex index " + std::to_string(index) + ", but there are " + std::to_string(vertex_count_) +
                   " vertices",
               "check that the file is whole, or export it again");
}

std::uint32_t PlyParser::vertex_index(PlyType type) {
  const std::int64_t index = values_.integer(type);
  if (index < 0 || static_cast<std::uint64_t>(index) >= vertex_count_) fail_index(index);
  return static_cast<std::uint32_t>(index);
}

void PlyParser::edges(const PlyElement& element) {
  segments_.reserve(segments_.size() + static_cast<std::size_t>(element.count));
  for (std::uint64_t i = 0; i < element.count; ++i) {
    glm::uvec2 ends(0u);
    for (const PlyProperty& property : element.properties) {
      if (property.role == PlyRole::vertex1)
        ends.x = vertex_index(property.type);
      else if (property.role == PlyRole::vertex2)
        ends.y = vertex_index(property.type);
      else
        skip(property);
    }
    segments_.push_back(ends);
  }
}

void PlyParser::corners(const PlyProperty& property, std::vector<std::uint32_t>& out) {
  const std::uint64_t count = list_length(property);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::int64_t index = values_.integer(property.type);
    const bool ends_strip = index == -1 && &out != &corners_;
    if (!ends_strip && (index < 0 || static_cast<std::uint64_t>(index) >= vertex_count_)) {
      fail_index(index);
    }
    out.push_back(static_cast<std::uint32_t>(index));
  }
}

void PlyParser::faces(const PlyElement& element) {
  corner_counts_.reserve(corner_counts_.size() + static_cast<std::size_t>(element.count));
  for (std::uint64_t i = 0; i < element.count; ++i) {
    const std::size_t before = corners_.size();
    bool is_read = false;
    for (const PlyProperty& property : element.properties) {
      if (property.role == PlyRole::corners && !is_read) {
        corners(property, corners_);
        is_read = true;
      } else {
        skip(property);
      }
    }
    corner_counts_.push_back(static_cast<std::uint32_t>(corners_.size() - before));
  }
}

// Every corner from the third on makes a triangle with the two before it; every second one is turned over.
void PlyParser::strips(const PlyElement& element) {
  constexpr std::uint32_t restart = 0xFFFFFFFFu;
  std::vector<std::uint32_t> strip;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    strip.clear();
    for (const PlyProperty& property : element.properties) {
      if (property.role == PlyRole::corners && strip.empty())
        corners(property, strip);
      else
        skip(property);
    }
    std::size_t length = 0;
    for (std::size_t c = 0; c < strip.size(); ++c) {
      length = strip[c] == restart ? 0 : length + 1;
      if (length < 3) continue;
      const bool is_turned = length % 2 == 0;
      triangles_.emplace_back(strip[c - (is_turned ? 1 : 2)], strip[c - (is_turned ? 2 : 1)], strip[c]);
    }
  }
}

void PlyParser::triangulate() {
  std::size_t count = triangles_.size(), small_faces = 0;
  for (const std::uint32_t corner_count : corner_counts_) {
    if (corner_count >= 3)
      count += corner_count - 2;
    else
      ++small_faces;
  }
  triangles_.reserve(count);
  Triangulator triangulator(Triangulator::steps_for(file_bytes_));
  std::string first_fan;
  std::vector<glm::vec3> outline;
  std::size_t first = 0;
  for (std::size_t face = 0; face < corner_counts_.size(); first += corner_counts_[face++]) {
    outline.clear();
    for (std::size_t c = first; c < first + corner_counts_[face]; ++c)
      outline.push_back(positions_[corners_[c]]);
    const std::size_t before = triangles_.size();
    if (!triangulator.triangulate(outline, triangles_)) {
      throw Error(ErrorKind::read,
                  "face " + std::to_string(face) + " (from 0) is concave with " +
                      std::to_string(outline.size()) + " corners, more than " +
                      std::to_string(Triangulator::most_concave_corners),
                  name_, "triangulate it in the program it comes from");
    }
    if (triangulator.fan_count() == 1 && first_fan.empty())
      first_fan = "face " + std::to_string(face) + " (from 0)";
    for (std::size_t t = before; t < triangles_.size(); ++t) {
      for (int i = 0; i < 3; ++i) triangles_[t][i] = corners_[first + triangles_[t][i]];
    }
  }
  if (!first_fan.empty()) notes_.push_back(triangulator.note_on_fans(first_fan));
  if (small_faces > 0)
    notes_.push_back(std::to_string(small_faces) + " faces with fewer than three corners are left out");
}

}  // namespace

Scene read_ply(std::span<const std::byte> bytes, const std::string& name, const LoadOptions& options) {
  return PlyParser(bytes, name).parse(options);
}

}  // namespace velum
