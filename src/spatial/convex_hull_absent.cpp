// Built where there is no Qhull.
#include "../base/error.hpp"
#include "convex_hull.hpp"

namespace velum {

bool has_convex_hull() {
  return false;
}

std::vector<glm::dvec3> convex_hull_normals(std::span<const glm::vec3>) {
  throw Error(ErrorKind::usage, "this velum was built without Qhull, so it has no convex hulls", {},
              "build it with -DVELUM_QHULL=ON where libqhull is installed, or take a 26-DOP");
}

}  // namespace velum
