#pragma once

#include <string>
#include <velum/pipeline/analytic_view.hpp>
#include <velum/velum.hpp>

namespace velum_app {

/// A built-in shape, as fine as its default times a factor, and the equation it stands for.
struct RoundShape {
  const char* name;
  velum::Mesh (*mesh)(int factor);  ///< 1, 2 or 4
  velum::AnalyticBody body;
};

/// What --analytic takes. @param input  builtin:NAME @throws velum::Error (usage) for what has no equation
const RoundShape& round_shape(const std::string& input);

}  // namespace velum_app
