#pragma once

#include <string>
#include <vector>
#include <velum/velum.hpp>

namespace velum_gallery {

/// Something to be shown under every projection.
struct Subject {
  std::string stem;   ///< part of file names
  std::string title;  ///< for people
  velum::Scene scene;
};

/// The built-in shapes, and those real files of Debian's packages that are installed. What is missing is
/// skipped and named in `skipped`.
std::vector<Subject> load_subjects(std::vector<std::string>& skipped);

}  // namespace velum_gallery
