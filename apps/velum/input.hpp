#pragma once

#include <string>
#include <velum/velum.hpp>

namespace velum_app {

/// The help text of the positional IN.
inline constexpr const char* input_help =
    "A mesh file (OBJ, STL, PLY), - for standard input, or builtin:NAME (cube, house, letter-f, torus, ...)";

/// Reads IN. @throws velum::Error (read), for an unknown built-in shape velum::Error (usage)
velum::Scene read_scene(const std::string& input);

/// The name of a picture of IN: "dir/bunny.obj" and "builtin:bunny" → "bunny", "-" → "stdin".
std::string stem_of(const std::string& input);

}  // namespace velum_app
