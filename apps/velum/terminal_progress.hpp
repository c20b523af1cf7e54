#pragma once

#include <velum/velum.hpp>

namespace velum_app {

/// Shows "rendering 34 %" on standard error when that is a terminal; an empty callback otherwise.
velum::Progress terminal_progress(bool quiet);
/// Takes the progress line away again.
void clear_progress(const velum::Progress& progress);

}  // namespace velum_app
