#pragma once

#include <filesystem>
#include <string>
#include <vector>
#include <velum/velum.hpp>

#include "parse_values.hpp"

namespace velum_app {

enum class OutputKind { colour, depth, metric_depth, normals, object_ids, triangle_ids, report, page };

/// A file that `velum render` was asked to write.
struct Output {
  OutputKind kind;
  std::string option;  ///< as in messages, e.g. "--depth"
  std::filesystem::path path;
};

/// Demands, before any work begins, that every output has an extension its kind is written in, that no two
/// go to the same place, and that their folders exist.
/// @throws velum::Error (usage) naming option and known extensions; (write) for a missing folder
void check_outputs(const std::vector<Output>& outputs);

/// Demands that no output goes to standard output where JSON does. @throws velum::Error (usage)
void check_json_is_alone(const std::vector<Output>& outputs, bool prints_json);

/// Demands, before any work begins, that those outputs that are PNGs can hold a picture of so many pixels.
/// @param opaque  whether the picture has a background that nothing shines through
/// @throws velum::Error (usage) naming the PNG
void check_png_sizes(const std::vector<Output>& outputs, const Size& size, bool opaque);

/// Writes one output, whole or not at all. @pre checked, and neither report nor page. @throws velum::Error
/// (write)
void write_output(const Output& output, const velum::Picture& picture);

/// The same for a drawing that is no part of a Picture. @pre output.kind is colour
void write_drawing(const Output& output, const velum::Image<velum::Rgba8>& drawing);

}  // namespace velum_app
