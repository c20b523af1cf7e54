#pragma once

#include <cstdint>

namespace velum {

/// What a primitive is.
enum class PrimitiveKind : std::uint8_t { triangle, segment, point };

/// A primitive's place: the instance, and the index among its mesh's triangles, segments or points.
struct PrimitivePlace {
  std::uint32_t instance = 0;
  std::uint32_t index = 0;
  PrimitiveKind kind = PrimitiveKind::triangle;
  bool operator==(const PrimitivePlace&) const = default;
};

}  // namespace velum
