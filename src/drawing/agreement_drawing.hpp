#pragma once

#include <string_view>

#include "../image/colour.hpp"
#include "../image/image.hpp"
#include "../pipeline/agree.hpp"
#include "../pipeline/picture.hpp"

namespace velum {

/// A class of pixels as it is named, explained and coloured.
struct AgreementClass {
  std::string_view name;
  std::string_view meaning;
  Rgba8 colour;
};

const AgreementClass& agreement_class(Agreement agreement);

/// The map of where two methods differ: the scene in faint grey, a mark in its class's colour at least 3×3
/// pixels large on every pixel that differs, 7×7 in a ring on every unexplained one, and below it the colours
/// with the pixels of each class. Small pictures are magnified.
/// @param beneath  the scene as it is shown in grey, as large as the report's picture
/// @pre beneath.colour and beneath.triangle_id have the size of report.classes
Image<Rgba8> draw_agreement(const AgreementReport& report, const Picture& beneath);

}  // namespace velum
