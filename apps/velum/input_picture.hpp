#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <variant>
#include <velum/velum.hpp>

namespace velum_app {

/// A picture as its file holds it: 8-bit colours, one float per pixel, or three.
using InputPicture = std::variant<velum::Image<velum::Rgba8>, velum::Image<float>, velum::Image<glm::vec3>>;

/// Reads a PNG, PPM or PFM, told apart by content. @throws velum::Error (read)
InputPicture read_picture(const std::string& path);

/// What it holds, for a sentence: "8-bit colours".
const char* content_of(const InputPicture& picture);

}  // namespace velum_app
