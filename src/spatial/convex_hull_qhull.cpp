// Built where there is Qhull.
#include <cstdio>
#include <memory>

#include "convex_hull.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#include <libqhull_r/qhull_ra.h>
#pragma GCC diagnostic pop

namespace velum {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// A run of Qhull and what it holds.
struct Hull {
  qhT state{};

  Hull() { qh_zero(&state, nullptr); }
  ~Hull() {
    int long_bytes = 0, long_pieces = 0;
    qh_freeqhull(&state, !qh_ALL);
    qh_memfreeshort(&state, &long_bytes, &long_pieces);
  }
  Hull(const Hull&) = delete;
  Hull& operator=(const Hull&) = delete;
};

}  // namespace

bool has_convex_hull() {
  return true;
}

std::vector<glm::dvec3> convex_hull_normals(std::span<const glm::vec3> points) {
  std::vector<double> coordinates;
  coordinates.reserve(points.size() * 3);
  for (const glm::vec3& p : points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  std::vector<glm::dvec3> normals;
  if (points.size() < 4) return normals;
  // Qhull tells a file what it does not like: flat points, which are no fault here.
  const std::unique_ptr<std::FILE, CloseFile> nowhere(std::fopen("/dev/null", "w"));
  if (nowhere == nullptr) return normals;
  Hull hull;
  char command[] = "qhull";
  const int failure = qh_new_qhull(&hull.state, 3, static_cast<int>(points.size()), coordinates.data(), False,
                                   command, nullptr, nowhere.get());
  if (failure != 0) return normals;
  for (const facetT* facet = hull.state.facet_list; facet != nullptr && facet->next != nullptr;
       facet = facet->next) {
    normals.emplace_back(facet->normal[0], facet->normal[1], facet->normal[2]);
  }
  return normals;
}

}  // namespace velum
