#include "trace_json.hpp"

#include "trace_text.hpp"

namespace velum_app {
namespace {

using namespace velum;

Json json_of_snapped(const SnappedVertex& v) {
  return Json::array({v.x, v.y});
}

const char* name_of(FragmentOutcome outcome) {
  switch (outcome) {
    case FragmentOutcome::seen:
      return "seen";
    case FragmentOutcome::farther:
      return "farther";
    case FragmentOutcome::higher_id:
      return "higher id";
    case FragmentOutcome::same_triangle:
      break;
  }
  return "same triangle";
}

const char* name_of(TriangleFate fate) {
  switch (fate) {
    case TriangleFate::not_finite:
      return "not finite";
    case TriangleFate::culled:
      return "culled";
    case TriangleFate::rejected:
      return "rejected";
    case TriangleFate::accepted:
      return "accepted";
    case TriangleFate::to_clip:
      break;
  }
  return "clipped";
}

const char* name_of(ClipVerdict verdict) {
  switch (verdict) {
    case ClipVerdict::accepted:
      return "accepted";
    case ClipVerdict::rejected:
      return "rejected";
    case ClipVerdict::clipped:
      return "clipped";
    case ClipVerdict::clipped_away:
      break;
  }
  return "clipped away";
}

Json corners_json(const std::array<SnappedVertex, 3>& corners) {
  Json list = Json::array();
  for (const SnappedVertex& corner : corners) list.push_back(json_of_snapped(corner));
  return list;
}

Json depth_plane_json(const DepthPlane& plane) {
  return {{"r_ref", plane.r_ref}, {"dx", plane.dx},       {"dy", plane.dy},      {"x_ref", plane.x_ref},
          {"y_ref", plane.y_ref}, {"lower", plane.lower}, {"upper", plane.upper}};
}

Json fragment_json(const CoveringFragment& fragment) {
  Json edges = Json::array();
  for (const EdgeAtCentre& edge : fragment.edges) {
    edges.push_back({{"from", json_of_snapped(edge.from)},
                     {"to", json_of_snapped(edge.to)},
                     {"cross", edge.cross},
                     {"owns_its_points", edge.owns_its_points()},
                     {"value", edge.value}});
  }
  return {{"triangle", fragment.primitive},
          {"kind", kind_name(fragment.place.kind)},
          {"object", fragment.place.instance},
          {std::string("object_") + kind_name(fragment.place.kind), fragment.place.index},
          {"piece", fragment.piece},
          {"pieces", fragment.pieces},
          {"corners", corners_json(fragment.triangle.vertices)},
          {"edges", edges},
          {"depth_plane", depth_plane_json(fragment.triangle.depth)},
          {"r", fragment.reversed_depth},
          {"z", fragment.depth()},
          {"outcome", name_of(fragment.outcome)}};
}

Json place_json(const PlacedPoint& point) {
  Json json{{"clip", json_of(point.clip)},
            {"ndc", json_of(point.ndc)},
            {"pixel", Json::array({point.pixel.x, point.pixel.y})},
            {"snapped", nullptr}};
  if (point.is_snapped) json["snapped"] = json_of_snapped(point.snapped);
  return json;
}

Json vertex_json(const VertexTrace& vertex) {
  Json images = Json::array();
  for (const glm::dvec4& image : vertex.images) images.push_back(json_of(image));
  return {{"mesh_vertex", vertex.index},
          {"object", json_of(vertex.object)},
          {"images", images},
          {"clip", json_of(vertex.clip)},
          {"outside", planes_json(vertex.code)}};
}

Json traced_vertex_json(const TracedVertex& vertex) {
  Json json{{"clip", json_of(vertex.position)}, {"outside", planes_json(vertex.code)}};
  if (!vertex.is_cut()) return json;
  json["plane"] = clip_planes[static_cast<std::size_t>(vertex.plane)].name;
  json["inside_end"] = vertex.inside;
  json["outside_end"] = vertex.outside;
  json["d_in"] = vertex.d_in;
  json["d_out"] = vertex.d_out;
  json["t"] = vertex.t;
  return json;
}

}  // namespace

Json planes_json(Outcode code) {
  Json list = Json::array();
  for (int i = 0; i < clip_plane_count; ++i) {
    if ((code >> i & 1) != 0) list.push_back(clip_planes[static_cast<std::size_t>(i)].name);
  }
  return list;
}

Json json_of(const TriangleTrace& trace) {
  Json vertices = Json::array(), polygon = Json::array(), pieces = Json::array();
  for (const VertexTrace& vertex : trace.vertices) vertices.push_back(vertex_json(vertex));
  for (const PlacedPoint& point : trace.polygon) polygon.push_back(place_json(point));
  for (const ScreenTriangle& piece : trace.pieces) pieces.push_back(corners_json(piece.vertices));
  return {{"triangle", trace.primitive},
          {"object", trace.place.instance},
          {"object_triangle", trace.place.index},
          {"vertices", vertices},
          {"determinant", trace.assembled.determinant},
          {"mirrored", trace.mirrored},
          {"facing", trace.assembled.facing == Facing::front ? "front" : "back"},
          {"fate", name_of(trace.assembled.fate)},
          {"cut_by", planes_json(trace.cut_by)},
          {"polygon", polygon},
          {"pieces", pieces}};
}

Json json_of(const PixelExplanation& pixel) {
  Json fragments = Json::array();
  for (const CoveringFragment& fragment : pixel.fragments) fragments.push_back(fragment_json(fragment));
  return {{"pixel", Json::array({pixel.x, pixel.y})},
          {"centre", json_of_snapped(pixel.centre)},
          {"fragments", fragments},
          {"winner", pixel.winner ? json_of(*pixel.winner) : Json(nullptr)}};
}

Json json_of(const ClipTrace& trace) {
  Json vertices = Json::array(), steps = Json::array();
  for (const TracedVertex& vertex : trace.vertices) vertices.push_back(traced_vertex_json(vertex));
  for (const ClipStep& step : trace.steps) {
    steps.push_back({{"plane", clip_planes[static_cast<std::size_t>(step.plane)].name},
                     {"cuts", step.cuts},
                     {"removed", step.removed},
                     {"made", step.made},
                     {"polygon", step.polygon}});
  }
  return {{"vertices", vertices},
          {"verdict", name_of(trace.verdict)},
          {"steps", steps},
          {"result", trace.result}};
}

}  // namespace velum_app
