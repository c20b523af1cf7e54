#pragma once

#include <velum/velum.hpp>

namespace velum_app {

/// Shows "rendering 34 %" on standard error when that is a terminal; an empty callback otherwise.
velum::Progress terminal_progress(bool quiet);
/// Takes the progress line away at the end of its scope, also when an error leaves it.
class ProgressLine {
 public:
  explicit ProgressLine(const velum::Progress& progress) : is_shown_(static_cast<bool>(progress)) {}
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

 private:
  bool is_shown_;
};

}  // namespace velum_app
