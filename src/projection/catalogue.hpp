#pragma once

#include <optional>

#include "projection.hpp"

// The catalogue's rows with what makes a Projection of them; private to catalogue.cpp and
// parse_projection.cpp.

namespace velum {

/// The values given for a row's parameters, in the row's order; angles in radians.
struct ParameterValues {
  const ProjectionEntry* entry = nullptr;
  std::vector<std::optional<double>> given;

  /// As given, or the default.
  double operator[](std::size_t index) const;
};

/// A parameter's value as on the command line → as in the API.
double in_api_unit(const ProjectionEntry::Parameter& parameter, double value);

/// The Projection of row `index` of projection_catalogue(). @throws Error (usage) for values out of range
Projection make_projection(std::size_t index, const ParameterValues& values);

}  // namespace velum
