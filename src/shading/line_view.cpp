#include "line_view.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "../base/contract.hpp"
#include "shade.hpp"

namespace velum {
namespace {

/// v / |v|; zero for what has no direction.
glm::vec3 unit_or_zero(const glm::dvec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0.0) || !std::isfinite(largest)) return glm::vec3(0.0f);
  const glm::dvec3 scaled = v / largest;
  return glm::vec3(scaled / std::sqrt(glm::dot(scaled, scaled)));
}

template <typename Vector>
Vector between(const std::array<Vector, 2>& values, double t) {
  using Scalar = typename Vector::value_type;
  return values[0] + (values[1] - values[0]) * static_cast<Scalar>(t);
}

std::array<std::uint32_t, 2> vertices_of(const Mesh& mesh, const PrimitivePlace& place) {
  if (place.kind == PrimitiveKind::segment) {
    VELUM_REQUIRE(place.index < mesh.segments.size(), {"place.index", place.index});
    return {mesh.segments[place.index].x, mesh.segments[place.index].y};
  }
  VELUM_REQUIRE(place.kind == PrimitiveKind::point && place.index < mesh.points.size(),
                {"place.index", place.index});
  return {mesh.points[place.index], mesh.points[place.index]};
}

/// Homogeneous pixel coordinate along one axis: (s·w, w).
glm::dvec2 along_axis(const glm::dvec4& clip, bool x_major, const Viewport& viewport) {
  return {x_major ? 0.5 * viewport.width * (clip.x + clip.w) : 0.5 * viewport.height * (clip.w - clip.y),
          clip.w};
}

/// A normal by the cofactor matrix, as those of triangles; its sign does not matter here, see
/// surface_point().
glm::vec3 world_normal(const Mesh& mesh, std::uint32_t vertex, const glm::dmat4& world_from_object) {
  if (mesh.normals.empty()) return glm::vec3(0.0f);
  const glm::dvec3 x(world_from_object[0]), y(world_from_object[1]), z(world_from_object[2]);
  const glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
  return unit_or_zero(cofactors * glm::dvec3(mesh.normals[vertex]));
}

}  // namespace

LineView view_line(const Scene& scene, const PrimitivePlace& place, const glm::dmat4& clip_from_object,
                   const Viewer& viewer, bool x_major) {
  VELUM_REQUIRE(place.instance < scene.instances().size(), {"place.instance", place.instance});
  const Instance& instance = scene.instances()[place.instance];
  const Mesh& mesh = scene.meshes()[instance.mesh];
  const std::array<std::uint32_t, 2> vertices = vertices_of(mesh, place);

  LineView view;
  view.place = place;
  view.primitive = scene.primitive(place);
  view.material = &scene.materials()[instance.material];
  view.eye = viewer.eye;
  view.x_major = x_major;
  const glm::vec4 base(view.material->base_colour, view.material->alpha);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::uint32_t vertex = vertices[i];
    const glm::dvec4 object(mesh.positions[vertex], 1.0);
    view.along[i] = along_axis(clip_from_object * object, x_major, viewer.viewport);
    view.world[i] = glm::dvec3(instance.world_from_object * object);
    view.metric_depth[i] = glm::dot(viewer.metric_depth_plane, glm::dvec4(view.world[i], 1.0));
    view.normals[i] = world_normal(mesh, vertex, instance.world_from_object);
    view.colours[i] = mesh.colours.empty() ? base : base * mesh.colours[vertex];
    view.texture_coordinates[i] =
        mesh.texture_coordinates.empty() ? glm::vec2(0.0f) : mesh.texture_coordinates[vertex];
  }
  return view;
}

double parameter_at(const LineView& line, int x, int y) {
  return parameter_at(line, glm::dvec2(x + 0.5, y + 0.5));
}

double parameter_at(const LineView& line, const glm::dvec2& at) {
  if (line.place.kind == PrimitiveKind::point) return 0.0;
  // With the origin moved there, s(t) = 0 is linear: e0 + t·(e1 - e0) = 0.
  const double s = line.x_major ? at.x : at.y;
  const double e0 = line.along[0].x - s * line.along[0].y;
  const double e1 = line.along[1].x - s * line.along[1].y;
  const double t = e0 / (e0 - e1);
  if (!std::isfinite(t)) return line.metric_depth[1] < line.metric_depth[0] ? 1.0 : 0.0;
  return std::clamp(t, 0.0, 1.0);
}

SurfacePoint surface_point(const LineView& line, int x, int y, float reversed_depth) {
  return surface_point(line, {x + 0.5, y + 0.5}, x, y, reversed_depth);
}

SurfacePoint surface_point(const LineView& line, const glm::dvec2& at, int x, int y, float reversed_depth) {
  const double t = parameter_at(line, at);
  SurfacePoint point;
  point.position = between(line.world, t);
  point.to_viewer = to_viewer_from(point.position, line.eye);
  point.barycentric = glm::vec3(1.0 - t, t, 0.0);
  // Neither has an outside: the normal is taken on the viewer's side.
  const glm::vec3 normal = unit_or_zero(glm::dvec3(between(line.normals, t)));
  point.shading_normal = glm::dot(glm::dvec3(normal), point.to_viewer) < 0.0 ? -normal : normal;
  point.colour = between(line.colours, t);
  point.texture_coordinate = between(line.texture_coordinates, t);
  point.metric_depth = line.metric_depth[0] + (line.metric_depth[1] - line.metric_depth[0]) * t;
  point.depth = 1.0f - reversed_depth;
  point.object = line.place.instance;
  point.kind = line.place.kind;
  point.index = line.place.index;
  point.primitive = line.primitive;
  point.x = x;
  point.y = y;
  point.material = line.material;
  return point;
}

glm::vec4 shade_line(Shading shading, const Lighting& lighting, const SurfacePoint& point,
                     const MetricRange& range) {
  const bool is_lit = shading == Shading::flat || shading == Shading::gouraud || shading == Shading::phong;
  if (!is_lit) return shade(shading, lighting, LitTriangle{}, point, range);
  if (point.shading_normal == glm::vec3(0.0f)) return point.colour;
  return shade(Shading::phong, lighting, LitTriangle{}, point, range);
}

}  // namespace velum
