#pragma once

#include "shading.hpp"

namespace velum {

/// A shading and its name on the command line.
struct NamedShading {
  const char* name;
  Shading shading;
};

inline constexpr NamedShading shading_names[] = {
    {"flat", Shading::flat},
    {"gouraud", Shading::gouraud},
    {"phong", Shading::phong},
    {"normal", Shading::normal},
    {"depth", Shading::depth},
    {"object-id", Shading::object_id},
    {"triangle-id", Shading::triangle_id},
    {"barycentric", Shading::barycentric},
};

}  // namespace velum
