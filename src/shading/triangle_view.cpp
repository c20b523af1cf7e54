#include "triangle_view.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "../base/contract.hpp"

namespace velum {
namespace {

constexpr std::size_t next(std::size_t i) {
  return i == 2 ? 0 : i + 1;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// v / |v|, or `otherwise` when v has no direction. Scaled first, so that no square overflows or vanishes.
glm::dvec3 normalised(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0.0) || largest > std::numeric_limits<double>::max()) return otherwise;
  const glm::dvec3 scaled = v / largest;
  const double length = std::sqrt(glm::dot(scaled, scaled));
  return length > 0.0 ? scaled / length : otherwise;
}

/// Of the vertices in front of the viewer the one with the largest reversed depth (w - z)/w.
int nearest_vertex(const std::array<glm::dvec4, 3>& clip) {
  int nearest = 0;
  double largest = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const glm::dvec4& v = clip[static_cast<std::size_t>(i)];
    if (!(v.w > 0.0)) continue;
    const double r = (v.w - v.z) / v.w;
    if (r > largest) {
      largest = r;
      nearest = i;
    }
  }
  return nearest;
}

void set_up_picture(TriangleView& view, const Viewport& viewport) {
  view.determinant = homogeneous_determinant(view.clip[0], view.clip[1], view.clip[2]);
  view.is_in_front = view.clip[0].w > 0.0 && view.clip[1].w > 0.0 && view.clip[2].w > 0.0;
  view.nearest = nearest_vertex(view.clip);
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec4& v = view.clip[i];
    view.pixel[i] = {0.5 * viewport.width * (v.x + v.w), 0.5 * viewport.height * (v.w - v.y), v.w};
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 edge = glm::cross(view.pixel[next(i)], view.pixel[next(next(i))]);
    view.edge_gradient[i] = {edge.x, edge.y};
  }
}

/// The outward normal of the world triangle, turned to the viewer's side; seen edge-on it keeps its
/// orientation.
glm::dvec3 geometric_normal(const std::array<glm::dvec3, 3>& world, bool mirrored, const glm::dvec4& eye) {
  glm::dvec3 normal = normalised(glm::cross(world[1] - world[0], world[2] - world[0]), glm::dvec3(0.0));
  if (mirrored) normal = -normal;
  const glm::dvec3 towards_viewer = glm::dvec3(eye) - world[0] * eye.w;
  return glm::dot(normal, towards_viewer) < 0.0 ? -normal : normal;
}

/// The vertex normals in world space: by the cofactor matrix, which is the inverse transpose times the
/// determinant, so that it needs no division and exists for every matrix.
void set_up_normals(TriangleView& view, const Mesh& mesh, const glm::uvec3& indices,
                    const glm::dmat4& world_from_object, bool mirrored) {
  view.normals.fill(view.geometric_normal);
  if (mesh.normals.empty()) return;
  const glm::dvec3 x(world_from_object[0]), y(world_from_object[1]), z(world_from_object[2]);
  const glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
  const double sign = mirrored != (view.facing == Facing::back) ? -1.0 : 1.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 normal = cofactors * glm::dvec3(mesh.normals[indices[static_cast<int>(i)]]);
    view.normals[i] = normalised(normal * sign, glm::dvec3(view.geometric_normal));
  }
}

void set_up_attributes(TriangleView& view, const Mesh& mesh, const glm::uvec3& indices) {
  const glm::vec4 base(view.material->base_colour, view.material->alpha);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t vertex = indices[static_cast<int>(i)];
    view.colours[i] = mesh.colours.empty() ? base : base * mesh.colours[vertex];
    view.texture_coordinates[i] =
        mesh.texture_coordinates.empty() ? glm::vec2(0.0f) : mesh.texture_coordinates[vertex];
  }
}

Barycentrics at_vertex(int vertex) {
  Barycentrics result;
  result.exact[vertex] = result.clamped[vertex] = 1.0;
  return result;
}

/// The three edge planes at (px, py): edge i is opposite vertex i.
glm::dvec3 edge_values(const TriangleView& triangle, double px, double py) {
  std::array<glm::dvec2, 3> from_here;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3& p = triangle.pixel[i];
    from_here[i] = {p.x - px * p.z, p.y - py * p.z};
  }
  return {cross(from_here[1], from_here[2]), cross(from_here[2], from_here[0]),
          cross(from_here[0], from_here[1])};
}

}  // namespace

glm::dvec3 to_viewer_from(const glm::dvec3& position, const glm::dvec4& eye) {
  const glm::dvec3 direction = eye.w != 0.0 ? glm::dvec3(eye) / eye.w - position : glm::dvec3(eye);
  return normalised(direction, glm::dvec3(0.0));
}

TriangleView view_triangle(const Scene& scene, const PrimitivePlace& place,
                           const glm::dmat4& clip_from_object, const Viewer& viewer) {
  VELUM_REQUIRE(place.instance < scene.instances().size(), {"place.instance", place.instance});
  const Instance& instance = scene.instances()[place.instance];
  const Mesh& mesh = scene.meshes()[instance.mesh];
  VELUM_REQUIRE(place.kind == PrimitiveKind::triangle && place.index < mesh.triangles.size(),
                {"place.index", place.index});
  const glm::uvec3& indices = mesh.triangles[place.index];

  TriangleView view;
  view.place = place;
  view.primitive = scene.primitive(place);
  view.material = &scene.materials()[instance.material];
  view.eye = viewer.eye;
  view.texture_filter = viewer.texture_filter;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec4 object(mesh.positions[indices[static_cast<int>(i)]], 1.0);
    view.clip[i] = clip_from_object * object;
    view.world[i] = glm::dvec3(instance.world_from_object * object);
    view.metric_depth[i] = glm::dot(viewer.metric_depth_plane, glm::dvec4(view.world[i], 1.0));
  }
  set_up_picture(view, viewer.viewport);
  const bool mirrored = is_mirroring(instance.world_from_object);
  view.facing = facing_of(view.determinant, mirrored);
  view.geometric_normal = geometric_normal(view.world, mirrored, viewer.eye);
  set_up_normals(view, mesh, indices, instance.world_from_object, mirrored);
  set_up_attributes(view, mesh, indices);
  return view;
}

Barycentrics barycentrics_at(const TriangleView& triangle, double px, double py) {
  if (triangle.determinant == 0.0) return at_vertex(triangle.nearest);
  const glm::dvec3 edges = edge_values(triangle, px, py);
  const double sum = edges.x + edges.y + edges.z;
  Barycentrics result;
  result.exact = edges / sum;
  // The plane's horizon (sum 0) is never seen; snapping may still show a pixel that close to it.
  if (!(std::abs(sum) > 0.0) || !std::isfinite(glm::dot(result.exact, result.exact)))
    return at_vertex(triangle.nearest);
  result.clamped = glm::max(result.exact, glm::dvec3(0.0));
  result.clamped /= result.clamped.x + result.clamped.y + result.clamped.z;
  return result;
}

glm::dmat2 texture_derivatives_at(const TriangleView& triangle, double px, double py) {
  const glm::dmat2 none(0.0);
  const auto& coordinates = triangle.texture_coordinates;
  const bool is_constant = coordinates[0] == coordinates[1] && coordinates[1] == coordinates[2];
  if (triangle.determinant == 0.0 || is_constant) return none;
  const glm::dvec3 edges = edge_values(triangle, px, py);
  const double sum = edges.x + edges.y + edges.z;
  const glm::dvec2 at = (glm::dvec2(coordinates[0]) * edges.x + glm::dvec2(coordinates[1]) * edges.y +
                         glm::dvec2(coordinates[2]) * edges.z) /
                        sum;
  glm::dmat2 change = none;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec2 from_here = glm::dvec2(coordinates[i]) - at;
    change[0] += from_here * triangle.edge_gradient[i].x;
    change[1] += from_here * triangle.edge_gradient[i].y;
  }
  change[0] /= sum;
  change[1] /= sum;
  const double size = glm::dot(change[0], change[0]) + glm::dot(change[1], change[1]);
  return std::isfinite(size) ? change : none;
}

}  // namespace velum
