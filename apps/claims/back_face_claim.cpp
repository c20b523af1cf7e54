// How many surfaces face away.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <plots/bar_plot.hpp>
#include <velum/projection/facing.hpp>

#include "claim.hpp"
#include "measure.hpp"

namespace velum_claims {
namespace {

using namespace velum;
using namespace velum_plots;

struct BackFaces {
  double mean = 0.0, least = 1.0, most = 0.0;
};

double share_of_back_faces(const Triangles& triangles, const glm::dmat4& clip_from_world) {
  std::size_t back = 0;
  const auto clip = [&](std::uint32_t i) {
    return clip_from_world * glm::dvec4(glm::dvec3(triangles.positions[i]), 1.0);
  };
  for (const glm::uvec3& t : triangles.triangles) {
    back += facing_of(homogeneous_determinant(clip(t.x), clip(t.y), clip(t.z)), false) == Facing::back;
  }
  return static_cast<double>(back) /
         static_cast<double>(std::max<std::size_t>(triangles.triangles.size(), 1));
}

BackFaces back_faces_of(const Subject& subject, int views) {
  Numbers numbers{11};
  BackFaces result;
  const Aabb bounds = subject.scene.bounds();
  for (int i = 0; i < views; ++i) {
    FrameOptions options;
    const glm::dvec3 towards = numbers.on_sphere();
    options.up = std::abs(towards.y) > 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    options.eye = bounds.centre() + towards * 1.2 * glm::length(bounds.size());
    const Camera camera = frame(bounds, parse_projection("perspective"), options);
    const double share = share_of_back_faces(subject.world, camera.viewing_transform(1.0).clip_from_world());
    result.mean += share / views;
    result.least = std::min(result.least, share);
    result.most = std::max(result.most, share);
  }
  return result;
}

}  // namespace

Claim claim_back_faces(const std::vector<Subject>& subjects, const Effort& effort) {
  Claim claim;
  claim.title = "Back faces are about half of all surfaces";
  claim.source =
      "\"Projektionen und Sichtbarkeit\": removing back faces, which make up about half of all surfaces.";
  claim.formula = "share = triangles with det(x, y, w) < 0 / all triangles, the raster's own test";
  claim.method =
      "Perspective views from all around, at 1.2 times the scene's diagonal. A perspective camera sees less "
      "than half of a "
      "convex body: the share is more than 1/2; of an open surface it depends on the side.";
  BarPlot plot{"Share of back faces", "views from all around", "%", {"least", "mean", "most"}, {}};
  double worst = 0.0;
  for (const Subject& subject : subjects) {
    const BackFaces share = back_faces_of(subject, effort.is_quick ? 6 : 40);
    plot.lines.push_back({subject.name, {100.0 * share.least, 100.0 * share.mean, 100.0 * share.most}});
    worst = std::max({worst, share.most - 0.5, 0.5 - share.least});
  }
  claim.figures.push_back(svg_of(plot));
  claim.verdict = worst < 0.12 ? Verdict::holds : Verdict::in_part;
  claim.reason =
      worst < 0.12
          ? "In no view is it farther than " + fixed(100.0 * worst, 0) + " percent points from half."
          : "In some view it is " + fixed(100.0 * worst, 0) +
                " percent points from half: true of closed surfaces, not of open ones and not of each view.";
  return claim;
}

}  // namespace velum_claims
