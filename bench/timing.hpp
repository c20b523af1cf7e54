#pragma once

#include <functional>
#include <vector>

namespace velum_bench {

/// How long the frames of one contender took, milliseconds.
struct Timing {
  double first = 0.0;  ///< the first frame: buffers are made, structures built
  double median = 0.0;
  double quarter = 0.0;         ///< a quarter of the frames took less …
  double three_quarters = 0.0;  ///< … and a quarter more
  int frames = 0;               ///< how many the last three were taken from

  double spread() const { return three_quarters - quarter; }
};

/// What is taken for time.
enum class Clock {
  wall,       ///< what a person waits
  processor,  ///< what all threads of this process computed: steadier on a busy machine, for one thread only
};

/// How frames are timed, and when to stop.
struct Patience {
  Clock clock = Clock::wall;
  int frames = 21;
  /// Seconds for one contender: fewer frames where they would take longer. A first frame that takes longer
  /// than this is the only one, and is the median, too.
  double seconds = 15.0;
};

/// Lets contenders draw frame after frame in turn, so that a slow moment of the machine meets all of them;
/// their first frames stand for themselves.
/// @return one Timing per contender
std::vector<Timing> time_in_turn(const std::vector<std::function<void()>>& contenders,
                                 const Patience& patience);

}  // namespace velum_bench
