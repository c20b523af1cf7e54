#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "../base/elementary.hpp"
#include "light_scene.hpp"

namespace velum {
namespace {

/// v / |v|; zero for zero.
glm::dvec3 unit(const glm::dvec3& v) {
  const double length = std::sqrt(glm::dot(v, v));
  return length > 0.0 ? v / length : glm::dvec3(0.0);
}

/// The part of the world's up axis across the viewing direction; seen from above or below, the direction the
/// named top view has up in its picture.
glm::dvec3 up_in_picture(UpAxis up, const glm::dvec3& to_viewer) {
  const glm::dvec3 axis = up == UpAxis::y ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 of_top_view = up == UpAxis::y ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
  const glm::dvec3 across = axis - to_viewer * glm::dot(axis, to_viewer);
  if (glm::dot(across, across) > 1e-6) return unit(across);
  return unit(of_top_view - to_viewer * glm::dot(of_top_view, to_viewer));
}

/// A lamp beside the viewer: `above` and `right` of the line of sight, as slopes.
DirectionalLight lamp(UpAxis up, const glm::dvec3& to_viewer, double above, double right, float radiance) {
  const glm::dvec3 towards = unit(to_viewer);
  const glm::dvec3 up_direction = up_in_picture(up, towards);
  const glm::dvec3 right_direction = glm::cross(up_direction, towards);
  return {-unit(towards + up_direction * above + right_direction * right), glm::vec3(radiance)};
}

/// A key light over the viewer's left shoulder, as draughtsmen light their objects: straight from the eye,
/// the three faces of an isometric cube would be equally bright. A weak light from the right keeps what turns
/// away from it readable.
void add_headlights(UpAxis up, const glm::dvec3& to_viewer, std::vector<DirectionalLight>& lights) {
  lights.push_back(lamp(up, to_viewer, 0.35, -0.25, 0.8f));
  lights.push_back(lamp(up, to_viewer, 0.1, 1.2, 0.25f));
}

/// What one light of unit direction `to_light` adds.
glm::vec3 reflected(const Material& material, const glm::dvec3& normal, const glm::dvec3& to_light,
                    const glm::dvec3& to_viewer, const glm::vec3& base) {
  const double n_l = glm::dot(normal, to_light);
  if (!(n_l > 0.0)) return glm::vec3(0.0f);
  const glm::vec3 diffuse = material.diffuse * base * static_cast<float>(n_l);
  const double n_h = glm::dot(normal, unit(to_light + to_viewer));
  if (!(n_h > 0.0) || material.specular == glm::vec3(0.0f)) return diffuse;
  const double highlight = elementary::pow(std::min(n_h, 1.0), static_cast<double>(material.shininess));
  return diffuse + material.specular * static_cast<float>(highlight);
}

}  // namespace

void light_scene(const Scene& scene, const glm::dvec3& to_viewer, Lighting& lighting) {
  lighting.ambient = scene.ambient_light;
  lighting.directional = scene.directional_lights;
  lighting.points = scene.point_lights;
  for (DirectionalLight& light : lighting.directional) light.direction = unit(light.direction);
  if (lighting.directional.empty() && lighting.points.empty())
    add_headlights(scene.up, to_viewer, lighting.directional);
}

Lighting lighting_of(const Scene& scene, const glm::dvec3& to_viewer) {
  Lighting lighting;
  light_scene(scene, to_viewer, lighting);
  return lighting;
}

// Blinn 1977, "Models of Light Reflection for Computer Synthesized Pictures": the half vector between light
// and viewer in place of Phong's mirrored ray.
glm::vec4 blinn_phong(const Lighting& lighting, const Material& material, const glm::dvec3& position,
                      const glm::vec3& normal, const glm::dvec3& to_viewer, const glm::vec4& base) {
  const glm::dvec3 n(normal);
  const glm::vec3 base_colour(base);
  glm::vec3 colour = lighting.ambient * material.ambient * base_colour;
  for (const DirectionalLight& light : lighting.directional)
    colour += light.radiance * reflected(material, n, -light.direction, to_viewer, base_colour);
  for (const PointLight& light : lighting.points)
    colour +=
        light.radiance * reflected(material, n, unit(light.position - position), to_viewer, base_colour);
  return {colour, base.a};
}

}  // namespace velum
