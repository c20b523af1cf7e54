#include "report.hpp"

#include <cmath>

#include "sha256.hpp"

namespace velum_app {
namespace {

using namespace velum;

Json by_plane(const std::uint64_t (&counts)[clip_plane_count]) {
  Json json;
  for (int i = 0; i < clip_plane_count; ++i) json[clip_planes[static_cast<std::size_t>(i)].name] = counts[i];
  return json;
}

Json counters_json(const Counters& c) {
  return {{"instances", c.instances},
          {"instances_beside", c.instances_beside},
          {"vertices", c.vertices},
          {"triangles", c.triangles},
          {"not_finite", c.not_finite},
          {"back_facing", c.back_facing},
          {"edge_on", c.edge_on},
          {"culled", c.culled},
          {"culled_share", c.culled_share()},
          {"trivially_accepted", c.trivially_accepted},
          {"trivially_rejected", c.trivially_rejected},
          {"clipped", c.clipped},
          {"clipped_away", c.clipped_away},
          {"at_eye", c.at_eye},
          {"outside", by_plane(c.outside)},
          {"cut_by", by_plane(c.cut_by)},
          {"segments", c.segments},
          {"segments_clipped", c.segments_clipped},
          {"segments_outside", c.segments_outside},
          {"points", c.points},
          {"points_outside", c.points_outside},
          {"screen_triangles", c.screen_triangles},
          {"zero_area", c.zero_area},
          {"reversed", c.reversed},
          {"pixels_shaded", c.pixels_shaded},
          {"layers", c.layers}};
}

/// The smallest step of depth at the far plane, world units; null if that has no end.
Json resolution_at_far(const Camera& camera, DepthFormat format) {
  const double step = depth_resolution_at(camera, format, camera.far());
  return std::isfinite(step) ? Json(step) : Json();
}

Json hashes_json(const Picture& picture) {
  return {{"colour", sha256_of(picture.colour.view())},
          {"depth", sha256_of(picture.depth.view())},
          {"object_id", sha256_of(picture.object_id.view())},
          {"triangle_id", sha256_of(picture.triangle_id.view())}};
}

Json box_json(const Rect& box) {
  if (box.is_empty()) return Json::array({0, 0, 0, 0});
  return Json::array({box.left, box.top, box.right(), box.bottom()});
}

Json by_level(const std::uint64_t (&counts)[most_pyramid_levels]) {
  Json json = Json::array();
  int levels = most_pyramid_levels;
  while (levels > 0 && counts[levels - 1] == 0) --levels;
  for (int i = 0; i < levels; ++i) json.push_back(counts[i]);
  return json;
}

Json json_of(const HierarchyCounters& c) {
  return {{"batches", c.batches},
          {"nodes_visited", c.nodes_visited},
          {"nodes_outside", c.nodes_outside},
          {"nodes_hidden", c.nodes_hidden},
          {"nodes_hidden_at", by_level(c.nodes_hidden_at)},
          {"clusters_away", c.clusters_away},
          {"clusters_drawn", c.clusters_drawn},
          {"clusters_remembered", c.clusters_remembered},
          {"triangles_left_out", c.triangles_left_out},
          {"polygons_tested", c.polygons_tested},
          {"polygons_hidden", c.polygons_hidden},
          {"polygons_hidden_at", by_level(c.polygons_hidden_at)},
          {"octree_bytes", c.octree_bytes}};
}

}  // namespace

Json report_of(const Picture& picture, const Camera& camera, const RenderSettings& settings) {
  const double aspect = static_cast<double>(settings.width) / settings.height;
  return {{"size", Json::array({picture.colour.width(), picture.colour.height()})},
          {"coverage", picture.coverage()},
          {"bbox", box_json(picture.bounding_box())},
          {"camera", json_of(camera)},
          {"depth_resolution_at_far", resolution_at_far(camera, settings.depth_format)},
          {"counters", counters_json(picture.counters)},
          {"stages", json_of(camera.viewing_transform(aspect).stages())},
          {"sha256", hashes_json(picture)}};
}

Json work_of(const Counters& counters) {
  return {{"hidden_triangles", counters.hidden_triangles},
          {"hidden_blocks", counters.hidden_blocks},
          {"drawn_blocks", counters.drawn_blocks},
          {"pixels_tested", counters.pixels_tested},
          {"spans", counters.spans},
          {"fragments", counters.fragments},
          {"fragments_written", counters.fragments_written},
          {"rays", counters.rays},
          {"ray_nodes", counters.ray_nodes},
          {"ray_boxes", counters.ray_boxes},
          {"ray_tests", counters.ray_tests},
          {"hierarchy", json_of(counters.hierarchy)}};
}

}  // namespace velum_app
