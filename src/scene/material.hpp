#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>

#include "../image/texture.hpp"

namespace velum {

/// How a texture goes on beyond its edges: again from the start, with the texel on the edge, or back and
/// forth.
enum class TextureWrap { repeat, clamp, mirror };

/// How a material lays a texture over its surface: looked up at scale · coordinate + offset.
struct TextureMapping {
  std::array<TextureWrap, 2> wrap{TextureWrap::repeat, TextureWrap::repeat};  ///< across, up
  glm::vec2 scale{1.0f};
  glm::vec2 offset{0.0f};
};

/// How a surface reflects and transmits light. Colours are linear. What is not drawn yet is kept.
struct Material {
  std::string name;
  glm::vec3 base_colour{0.8f, 0.8f, 0.8f};  ///< multiplied with ambient and diffuse
  std::string base_colour_texture;          ///< path of the picture (OBJ: map_Kd), or empty
  std::shared_ptr<const Texture> texture;   ///< multiplied with base colour and alpha; none: not drawn
  TextureMapping texture_mapping;
  glm::vec3 ambient{1.0f};          ///< share of the ambient light reflected, per channel
  glm::vec3 diffuse{1.0f};          ///< share of the diffuse light reflected, per channel
  glm::vec3 specular{0.04f};        ///< strength of the highlight, per channel
  float shininess = 32.0f;          ///< Blinn–Phong exponent, ≥ 0
  float alpha = 1.0f;               ///< opacity, 0…1
  float mirror_share = 0.0f;        ///< share of light reflected as by a mirror, 0…1
  float transmission_share = 0.0f;  ///< share of light refracted, 0…1
  glm::vec3 absorption{0.0f};       ///< per unit of length inside, per channel, ≥ 0
  float refractive_index = 1.0f;    ///< > 0
};

}  // namespace velum
