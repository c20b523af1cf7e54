#pragma once

#include <glm/vec3.hpp>
#include <string>

namespace velum {

/// How a surface reflects and transmits light. Colours are linear. What is not drawn yet is kept.
struct Material {
  std::string name;
  glm::vec3 base_colour{0.8f, 0.8f, 0.8f};  ///< multiplied with ambient and diffuse
  std::string base_colour_texture;          ///< path of the picture (OBJ: map_Kd), or empty
  glm::vec3 ambient{1.0f};                  ///< share of the ambient light reflected, per channel
  glm::vec3 diffuse{1.0f};                  ///< share of the diffuse light reflected, per channel
  glm::vec3 specular{0.04f};                ///< strength of the highlight, per channel
  float shininess = 32.0f;                  ///< Blinn–Phong exponent, ≥ 0
  float alpha = 1.0f;                       ///< opacity, 0…1
  float mirror_share = 0.0f;                ///< share of light reflected as by a mirror, 0…1
  float transmission_share = 0.0f;          ///< share of light refracted, 0…1
  glm::vec3 absorption{0.0f};               ///< per unit of length inside, per channel, ≥ 0
  float refractive_index = 1.0f;            ///< > 0
};

}  // namespace velum
