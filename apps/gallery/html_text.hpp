#pragma once

#include <string>
#include <string_view>
#include <velum/velum.hpp>

namespace velum_gallery {

/// A number with up to `digits` significant digits, the same in every locale.
std::string number_text(double value, int digits);
/// Text made safe between tags and in attributes.
std::string escaped(std::string_view text);
/// A stage as HTML: name, meaning and its matrix as a table.
std::string stage_html(const velum::Stage& stage);

}  // namespace velum_gallery
