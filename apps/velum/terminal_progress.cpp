#include "terminal_progress.hpp"

#include <unistd.h>

#include <iostream>

namespace velum_app {

velum::Progress terminal_progress(bool quiet) {
  if (quiet || isatty(STDERR_FILENO) == 0) return {};
  return [shown = -1](double share) mutable {
    const int percent = static_cast<int>(share * 100.0);
    if (percent != shown) std::cerr << "\rrendering " << percent << " %" << std::flush;
    shown = percent;
    return true;
  };
}

ProgressLine::~ProgressLine() {
  if (is_shown_) std::cerr << "\r                \r" << std::flush;
}

}  // namespace velum_app
