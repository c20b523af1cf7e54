#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "../scene/scene.hpp"
#include "surface_point.hpp"

namespace velum {

/// How visible surfaces are coloured.
enum class Shading {
  flat,         ///< lit once per triangle, with the geometric normal at its centroid
  gouraud,      ///< lit at the vertices, colours interpolated (Gouraud 1971)
  phong,        ///< normal interpolated, lit at every pixel (Phong 1975, with Blinn's 1977 half vector)
  normal,       ///< the shading normal, (n + 1) / 2
  depth,        ///< metric depth, near bright … far dark
  object_id,    ///< a stable distinct colour per instance
  triangle_id,  ///< a stable distinct colour per primitive
  barycentric,  ///< the barycentric coordinates as red, green, blue
};

/// The lights of a scene ready for shading; a scene without lights gets two headlights: a key light
/// over the viewer's left shoulder and a weak one from the right.
struct Lighting {
  glm::vec3 ambient{0.0f};
  std::vector<DirectionalLight> directional;  ///< direction of unit length
  std::vector<PointLight> points;
};

/// @param to_viewer  direction from the scene to the viewer at the picture's centre; the headlights stand
/// beside it
Lighting lighting_of(const Scene& scene, const glm::dvec3& to_viewer);

/// Blinn–Phong in linear light: ambient + Σ radiance·(diffuse·base·max(0,n·l) +
/// specular·max(0,n·h)^shininess).
/// @param normal  unit length, on the viewer's side
/// @param base    linear base colour, straight alpha, kept in the result
glm::vec4 blinn_phong(const Lighting& lighting, const Material& material, const glm::dvec3& position,
                      const glm::vec3& normal, const glm::dvec3& to_viewer, const glm::vec4& base);

/// A stable, well separated colour for an id (linear, alpha 1). Neighbouring ids differ strongly;
/// no_primitive is black.
glm::vec4 id_colour(std::uint32_t id);

}  // namespace velum
