#pragma once

#include <string>
#include <vector>

#include "pictures.hpp"

namespace velum_gallery {

/// The page index.html: self-contained but for the pictures beside it; no script.
std::string page_html(const std::vector<Section>& sections);

/// The page's style sheet: a responsive grid, light and dark as the reader's system is set.
extern const char* const style_sheet;

}  // namespace velum_gallery
