#pragma once

#include <string>

namespace velum_bench {

/// What this machine can do at all, measured now: nothing that renders can be faster.
struct MachineLimits {
  struct Pair {
    double one;  ///< on one thread
    double two;  ///< on two
  };
  Pair memset_cached;    ///< bytes/s: memset of 8 MB
  Pair memset_uncached;  ///< bytes/s: memset of 64 MB
  Pair vertices_float;   ///< vertices/s: times a 4×4 and divided, float32, blocks that stay in cache
  Pair vertices_double;  ///< the same in double, as velum's exactness wants it
};

MachineLimits measure_machine_limits();

/// The processor's name, how many threads it runs, and how busy the machine is already.
std::string machine_description();
/// The system's load of the last minute; 0 if it does not tell.
double load_average();

}  // namespace velum_bench
