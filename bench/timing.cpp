#include "timing.hpp"

#include <algorithm>
#include <chrono>

namespace velum_bench {
namespace {

double milliseconds_of(const std::function<void()>& frame) {
  const auto begin = std::chrono::steady_clock::now();
  frame();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

/// How many frames to take after a first one of so many milliseconds; 0: the first is all there is.
int frames_after(double first, const Patience& patience) {
  const double fitting = patience.seconds * 1000.0 / std::max(first, 1e-3);
  if (fitting < 1.0) return 0;
  return static_cast<int>(std::min(fitting, static_cast<double>(patience.frames)));
}

Timing timing_of(double first, std::vector<double> times) {
  if (times.empty()) times.push_back(first);
  std::sort(times.begin(), times.end());
  const std::size_t n = times.size();
  return {first, times[n / 2], times[n / 4], times[n * 3 / 4], static_cast<int>(n)};
}

}  // namespace

std::vector<Timing> time_in_turn(const std::vector<std::function<void()>>& contenders,
                                 const Patience& patience) {
  struct Course {
    double first;
    int frames;
    std::vector<double> times;
  };
  std::vector<Course> courses;
  int rounds = 0;
  for (const auto& contender : contenders) {
    const double first = milliseconds_of(contender);
    courses.push_back({first, frames_after(first, patience), {}});
    rounds = std::max(rounds, courses.back().frames);
  }
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      if (round < courses[i].frames) courses[i].times.push_back(milliseconds_of(contenders[i]));
    }
  }
  std::vector<Timing> timings;
  for (Course& course : courses) timings.push_back(timing_of(course.first, std::move(course.times)));
  return timings;
}

}  // namespace velum_bench
