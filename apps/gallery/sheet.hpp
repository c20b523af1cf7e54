#pragma once

#include <filesystem>
#include <vector>

#include "subjects.hpp"

namespace velum_gallery {

/// One picture of several subjects under several projections, side by side: the picture of the README.
/// Subjects that are missing leave their tile empty.
void write_sheet(const std::filesystem::path& path, const std::vector<Subject>& subjects);

}  // namespace velum_gallery
