// How much of the time intersections take.
#include <algorithm>
#include <cmath>
#include <plots/bar_plot.hpp>

#include "claim.hpp"
#include "measure.hpp"

namespace velum_claims {
namespace {

using namespace velum;
using namespace velum_plots;

struct Shares {
  double rays = 0.0, intersection = 0.0, rest = 0.0;  ///< seconds

  double share() const { return intersection / std::max(rays + intersection + rest, 1e-12); }
};

/// All triangles in one mesh: no instances' boxes spare brute force anything.
Scene as_one_mesh(const Subject& subject) {
  Mesh mesh;
  mesh.positions = std::vector<glm::vec3>(subject.world.positions);
  mesh.triangles = std::vector<glm::uvec3>(subject.world.triangles);
  Scene scene;
  scene.add(std::move(mesh));
  return scene;
}

/// Four by two pixels each, as a frame casts them together. @pre width is a multiple of 4
std::vector<ViewRay> in_packets(const std::vector<ViewRay>& by_row, int width, int height) {
  std::vector<ViewRay> rays;
  rays.reserve(by_row.size());
  for (int top = 0; top < height; top += 2) {
    for (int left = 0; left < width; left += 4) {
      for (int y = top; y < std::min(top + 2, height); ++y) {
        const auto first = by_row.begin() + static_cast<std::ptrdiff_t>(y) * width + left;
        rays.insert(rays.end(), first, first + 4);
      }
    }
  }
  return rays;
}

Shares shares_of(const Subject& subject, const Scene& scene, AcceleratorKind kind, int width) {
  const int height = width * 3 / 4;
  const Camera camera = camera_of(subject, static_cast<double>(width) / height);
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.threads = 1;
  settings.visibility = VisibilityMethod::raycast;
  settings.accelerator = kind;
  Renderer renderer;
  renderer.render(scene, camera, settings);  // builds the structure
  const int runs = 3;
  const double frame = least_time(runs, [&] { renderer.render(scene, camera, settings); });
  const SceneCaster caster(scene, kind);
  CastCounters counters;
  std::vector<ViewRay> rays;
  const double making = least_time(runs, [&] { rays = camera_rays(camera, width, height); });
  const std::vector<ViewRay> packets = in_packets(rays, width, height);
  std::vector<SceneHit> hits(packets.size());
  const double casting = least_time(runs, [&] { caster.first_hits(packets, hits, counters); });
  return {making, casting, std::max(frame - making - casting, 0.0)};
}

}  // namespace

Claim claim_share_of_intersection(const std::vector<Subject>& subjects, const Effort& effort) {
  Claim claim;
  claim.title = "About 95 % of the time goes into intersections";
  claim.source =
      "\"Projektionen und Sichtbarkeit\": ray casting has the disadvantage of frequent intersections, about "
      "95 % of the time in typical scenes.";
  claim.formula = "share = time of first_hits / time of the frame";
  claim.method =
      "A frame with ray casting and Phong shading, one thread, structures built before; the rays alone, and "
      "their first hits alone, in the packets of eight that the frame casts, are timed apart. Everything on "
      "the way to a hit counts as intersection: "
      "boxes, cells and triangles. The rest: depth, shading, colours.";
  Table table({"scene", "structure", "rays", "intersections", "the rest", "share of intersections"},
              "llrrrr");
  BarPlot plot{"Share of the time that intersections take",
               "one frame, one thread",
               "%",
               {"brute force", "hierarchy"},
               {}};
  double least_brute = 1.0, least_bvh = 1.0, most_bvh = 0.0;
  for (const Subject& subject : subjects) {
    const auto n = static_cast<double>(std::max<std::size_t>(subject.world.triangles.size(), 1));
    // About a second of brute force in all.
    const int few = static_cast<int>(std::clamp(std::sqrt(2e7 / n), 8.0, 160.0)) / 4 * 4;
    const Scene scene = as_one_mesh(subject);
    const Shares brute = shares_of(subject, scene, AcceleratorKind::brute_force, effort.is_quick ? 16 : few);
    const Shares bvh = shares_of(subject, scene, AcceleratorKind::bvh, effort.is_quick ? 64 : 400);
    for (const auto& [name, s] : {std::pair{"brute force", brute}, std::pair{"bvh", bvh}}) {
      const double all = s.rays + s.intersection + s.rest;
      table.add({subject.name, name, fixed(100.0 * s.rays / all, 1) + " %",
                 fixed(100.0 * s.intersection / all, 1) + " %", fixed(100.0 * s.rest / all, 1) + " %",
                 fixed(100.0 * s.share(), 1) + " %"});
    }
    plot.lines.push_back({subject.name, {100.0 * brute.share(), 100.0 * bvh.share()}});
    least_brute = std::min(least_brute, brute.share());
    least_bvh = std::min(least_bvh, bvh.share());
    most_bvh = std::max(most_bvh, bvh.share());
  }
  claim.figures.push_back(svg_of(plot));
  claim.tables.push_back(table);
  claim.verdict = least_brute < 0.9 ? Verdict::does_not_hold
                  : least_bvh < 0.9 ? Verdict::in_part
                                    : Verdict::holds;
  claim.reason = "Without a structure at least " + fixed_down(100.0 * least_brute, 1) +
                 " %; with a bounding volume hierarchy " +
                 fixed_range(100.0 * least_bvh, 100.0 * most_bvh, 1) +
                 " %: the fewer intersections are left, the more the rest counts.";
  return claim;
}

}  // namespace velum_claims
