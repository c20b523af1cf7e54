#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace velum_bench {

/// What velum set out to reach on a scene: llvmpipe's time / velum's, one core each.
struct RatioGoal {
  std::string_view scene;
  double wanted;
  double hoped;
};
inline constexpr std::array<RatioGoal, 7> ratio_goals{{{"bunny", 10, 15},
                                                       {"castle", 9, 12},
                                                       {"sponza", 9, 14},
                                                       {"bunny16", 25, 35},
                                                       {"fill32_f2b", 20, 30},
                                                       {"fill32_b2f", 18, 25},
                                                       {"bunnies1000", 150, 250}}};

inline std::optional<RatioGoal> ratio_goal(std::string_view scene) {
  for (const RatioGoal& goal : ratio_goals) {
    if (goal.scene == scene) return goal;
  }
  return {};
}

/// MaskedOcclusionCulling (Intel, snapshot 6cbbd76; depth only, approximate, one thread) on the same scenes
/// and cameras on another machine, with llvmpipe's depth only beside it there: since it is in no package, its
/// time here is taken to be as many times shorter than llvmpipe's as it was there.
struct OcclusionGoal {
  std::string_view scene;
  double their_milliseconds;
  double llvmpipe_milliseconds;  ///< its depth only, one core, there
  double wanted;                 ///< velum's depth-only time / theirs, at most
};
inline constexpr std::array<OcclusionGoal, 4> occlusion_goals{{{"bunny", 3.1, 42.0, 1.5},
                                                               {"castle", 2.2, 42.0, 1.5},
                                                               {"sponza", 10.3, 146.0, 1.5},
                                                               {"bunny16", 38.0, 369.0, 0.4}}};

inline constexpr double wanted_speedup = 1.7;  ///< of two threads
inline constexpr std::array<std::string_view, 2> speedup_scenes{"sponza", "bunny16"};

/// What velum's ray casting set out to reach: the time of Embree's scenes with RTC_SCENE_FLAG_ROBUST /
/// velum's, one thread each; `what` as in RayRow.
struct RayGoal {
  std::string_view what;
  double wanted;
};
inline constexpr std::array<RayGoal, 5> ray_goals{{{"primary, packets", 0.8},
                                                   {"primary, single", 1.0},
                                                   {"incoherent", 0.8},
                                                   {"shadow", 0.8},
                                                   {"build", 0.5}}};
inline constexpr double wanted_ray_speedup = 1.8;        ///< of two threads
inline constexpr double most_bytes_per_triangle = 70.0;  ///< of the structure, on memory_scene
inline constexpr double least_same_hits = 0.99;          ///< share of rays that hit what Embree's hit

inline constexpr double most_memory = 150e6;  ///< bytes beyond the scene
inline constexpr std::string_view memory_scene = "bunny16";

}  // namespace velum_bench
