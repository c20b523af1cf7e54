#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "material.hpp"

namespace velum {

/// Materials by name.
using MaterialLibrary = std::unordered_map<std::string, Material>;

/// Adds the materials of a Wavefront MTL file to the library; a name that is there already is kept as it is.
/// Names are compared without blanks at their ends. The numbers are reflectances, so they are taken as
/// linear:
///
/// - Kd → base_colour; diffuse stays 1.
/// - Ka → ambient = Ka / Kd per channel, at most 1, because the base colour is multiplied in again. Absent or
///   0 0 0 (what exporters write that know no ambient light) → 1.
/// - Ks → specular, Ns → shininess; illum 0 and 1 mean no highlight.
/// - d → alpha, Tr → 1 - alpha where there is no d. Ni → refractive_index where it is positive.
/// - illum 3, 4, 5, 6, 7 → mirror_share, the largest channel of Ks. illum 4, 6, 7, 9 → transmission_share,
/// the
///   largest channel of Tf, or 1 - alpha without Tf.
/// - map_Kd → base_colour_texture, the path relative to `directory`; without Kd the base colour is then
/// white.
///   -clamp on → wrap, -o → offset, -s → scale (so that -s 2 2 shows it twice each way); others are skipped.
///
/// @param notes  is told of statements that are left out
/// @throws Error (read) with file:line
void read_mtl(std::string_view text, const std::string& name, const std::filesystem::path& directory,
              MaterialLibrary& library, std::vector<std::string>& notes);

/// The path of a file that another one names: relative to the directory, '\' as '/', and of an absolute path,
/// which is another machine's as a rule, the last part only.
std::filesystem::path beside(const std::filesystem::path& directory, std::string_view named);

}  // namespace velum
