#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace velum {

/// A corner of a polygon: places in the lists of ObjStatements, or no_index.
struct ObjCorner {
  static constexpr std::uint32_t no_index = 0xFFFFFFFFu;
  std::uint32_t position = no_index;
  std::uint32_t texture = no_index;
  std::uint32_t normal = no_index;
};

struct ObjPolygon {
  std::uint32_t corner_count;
  std::uint32_t line;
};

/// Consecutive polygons, segments and points of one object with one material; they end where the next run
/// begins.
struct ObjRun {
  std::string_view object;
  std::string_view material;
  std::size_t first_polygon;
  std::size_t first_segment;
  std::size_t first_point;
};

/// What stands in an OBJ file, one to one, indices resolved and in range. Names view the file's text.
struct ObjStatements {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec4> colours;  ///< empty, or one per position; linear
  std::vector<glm::vec2> texture_coordinates;
  std::vector<glm::vec3> normals;  ///< as they stand in the file
  std::vector<ObjCorner> corners;
  std::vector<ObjPolygon> polygons;  ///< in file order; their corners follow one another in `corners`
  std::vector<glm::uvec2> segments;  ///< of line elements, in file order: places in `positions`
  std::vector<std::uint32_t> points;
  std::vector<ObjRun> runs;
  std::vector<std::string_view> libraries;  ///< mtllib, in file order
  std::vector<std::string> notes;
};

/// @param name  shown in errors
/// @throws Error (read) with file:line
ObjStatements read_obj_statements(std::string_view text, const std::string& name);

/// Whether a line that begins with this word may stand in an OBJ file.
bool is_obj_keyword(std::string_view word);

}  // namespace velum
