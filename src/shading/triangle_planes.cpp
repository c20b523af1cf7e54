#include "triangle_planes.hpp"

#include <algorithm>

namespace velum {
namespace {

/// One component of three vectors: the first, and the others' differences to it, as interpolate() forms them.
template <typename Vector, typename Scalar>
void set_plane(const std::array<Vector, 3>& values, int component, Scalar (&plane)[3]) {
  plane[0] = values[0][component];
  plane[1] = values[1][component] - values[0][component];
  plane[2] = values[2][component] - values[0][component];
}

/// What a texture is looked up by.
void set_texture(const TriangleView& triangle, TrianglePlanes& planes) {
  const std::array<glm::vec2, 3>& coordinates = triangle.texture_coordinates;
  planes.is_texture_constant = coordinates[0] == coordinates[1] && coordinates[1] == coordinates[2];
  for (int i = 0; i < 3; ++i) {
    const auto vertex = static_cast<std::size_t>(i);
    for (int axis = 0; axis < 2; ++axis) {
      planes.texture[axis][i] = static_cast<double>(coordinates[vertex][axis]);
      planes.edge_gradient[i][axis] = triangle.edge_gradient[vertex][axis];
    }
  }
}

}  // namespace

TrianglePlanes planes_of(const TriangleView& triangle, const std::array<glm::vec4, 3>& colours,
                         const std::array<glm::vec3, 3>* highlights) {
  TrianglePlanes planes{};
  for (int i = 0; i < 3; ++i) {
    const auto vertex = static_cast<std::size_t>(i);
    for (int axis = 0; axis < 3; ++axis) planes.pixel[i][axis] = triangle.pixel[vertex][axis];
    planes.geometric_normal[i] = triangle.geometric_normal[i];
    set_plane(triangle.world, i, planes.world[i]);
    set_plane(triangle.normals, i, planes.normal[i]);
  }
  planes.nearest[triangle.nearest] = 1.0;
  for (int channel = 0; channel < 4; ++channel) set_plane(colours, channel, planes.colour[channel]);
  const std::array<double, 3>& depth = triangle.metric_depth;
  planes.metric_depth[0] = depth[0];
  planes.metric_depth[1] = depth[1] - depth[0];
  planes.metric_depth[2] = depth[2] - depth[0];
  planes.lowest = std::min({depth[0], depth[1], depth[2]});
  planes.highest = std::max({depth[0], depth[1], depth[2]});
  planes.has_place = triangle.eye.w != 0.0;
  const glm::dvec3 eye =
      planes.has_place ? glm::dvec3(triangle.eye) / triangle.eye.w : glm::dvec3(triangle.eye);
  for (int axis = 0; axis < 3; ++axis) planes.eye[axis] = eye[axis];
  planes.is_in_front = triangle.is_in_front;
  planes.has_highlight = highlights != nullptr;
  for (int channel = 0; planes.has_highlight && channel < 3; ++channel)
    set_plane(*highlights, channel, planes.highlight[channel]);
  set_texture(triangle, planes);
  return planes;
}

}  // namespace velum
