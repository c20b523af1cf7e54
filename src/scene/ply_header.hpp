#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace velum {

enum class PlyEncoding { ascii, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// What a property of a vertex, a face, a strip or an edge means here.
enum class PlyRole { none, x, y, z, nx, ny, nz, red, green, blue, alpha, u, v, corners, vertex1, vertex2 };
inline constexpr std::size_t ply_role_count = 16;

struct PlyProperty {
  PlyRole role = PlyRole::none;
  PlyType type = PlyType::float32;
  PlyType count_type = PlyType::uint8;  ///< of a list
  bool is_list = false;
};

struct PlyElement {
  std::string_view name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

/// The header of a PLY file. Names view its text.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t size = 0;        ///< bytes up to the data
  std::size_t line_count = 0;  ///< lines up to the data
};

std::size_t size_of(PlyType type);
bool is_real(PlyType type);

/// Whether the bytes begin as every PLY file does.
bool has_ply_magic(std::string_view text);

/// @throws Error (read) with file:line
PlyHeader read_ply_header(std::string_view text, const std::string& name);

}  // namespace velum
