#pragma once

#include <cstdint>

/// Checks of the built-in shapes' parameters. Each throws Error (usage) with the shape, the parameter, its
/// value and the range it must be in.
namespace velum::shapes {

/// A length from 1e-15 to 1e15: products of three stay far from overflow and underflow in double, areas and
/// volumes in float.
void require_length(const char* shape, const char* parameter, float value);
void require_below(const char* shape, const char* parameter, float value, const char* other,
                   float other_value);
void require_count(const char* shape, const char* parameter, int value, int lowest, int highest);
/// At most 2²⁶ triangles (some 3 GB).
void require_triangles(const char* shape, std::int64_t triangles);

}  // namespace velum::shapes
