#pragma once

#include <filesystem>
#include <string>
#include <vector>
#include <velum/velum.hpp>

#include "subjects.hpp"

namespace velum_gallery {

/// One picture on the page.
struct Shot {
  std::string file;     ///< relative to the page
  std::string caption;  ///< what is seen
  velum::StageList stages;
  double coverage = 0.0;
};

/// A heading of the page with its pictures.
struct Section {
  std::string id;
  std::string title;
  std::string family;
  std::string summary;
  std::string parameters;  ///< e.g. "angle = 45°, scale = 0.5"; empty for none
  std::string source;
  std::vector<Shot> shots;
};

inline constexpr int shot_width = 480;
inline constexpr int shot_height = 360;

/// Renders every subject under a projection of the catalogue into folder/*.png.
Section render_projection(velum::Renderer& renderer, const velum::ProjectionEntry& entry,
                          const std::vector<Subject>& subjects, const std::filesystem::path& folder);

/// One subject with every way of colouring it.
Section render_shadings(velum::Renderer& renderer, const Subject& subject,
                        const std::filesystem::path& folder);

}  // namespace velum_gallery
