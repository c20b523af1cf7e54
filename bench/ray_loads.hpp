#pragma once

#include <string>
#include <vector>
#include <velum/velum.hpp>

#include "scenes.hpp"

namespace velum_bench {

/// Rays of one kind and the part of each that counts. Every eight on end start near each other where the kind
/// allows it.
struct RayLoad {
  std::string name;
  std::vector<velum::ViewRay> rays;
};

/// What is cast at a benchmark scene.
struct RayLoads {
  RayLoad primary;     ///< through every pixel's centre, in blocks of 4 × 2 pixels
  RayLoad incoherent;  ///< from each primary hit one about the surface's normal, its cosine the density
  RayLoad shadow;      ///< from each primary hit to a light beside the camera; t = 1 is there
};

/// The same rays on every machine. @param caster  of the scene's only mesh
RayLoads make_ray_loads(const BenchScene& bench, const velum::Accelerator& caster);

}  // namespace velum_bench
