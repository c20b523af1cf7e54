#include "timing.hpp"

#include <algorithm>
#include <ctime>

namespace velum_bench {
namespace {

double now(Clock clock) {
  timespec time{};
  clock_gettime(clock == Clock::wall ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

double milliseconds_of(const std::function<void()>& frame, Clock clock) {
  const double begin = now(clock);
  frame();
  return now(clock) - begin;
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
    const double first = milliseconds_of(contender, patience.clock);
    courses.push_back({first, frames_after(first, patience), {}});
    rounds = std::max(rounds, courses.back().frames);
  }
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      if (round < courses[i].frames)
        courses[i].times.push_back(milliseconds_of(contenders[i], patience.clock));
    }
  }
  std::vector<Timing> timings;
  for (Course& course : courses) timings.push_back(timing_of(course.first, std::move(course.times)));
  return timings;
}

}  // namespace velum_bench
