#include "wireframe.hpp"

#include <algorithm>
#include <array>

namespace velum {
namespace {

/// Rec. 709, linear.
float luminance(const glm::vec4& colour) {
  return 0.2126f * colour.r + 0.7152f * colour.g + 0.0722f * colour.b;
}

/// How well two luminances are told apart, 1 … 21 (Web Content Accessibility Guidelines 2.0, 2008).
float contrast(float a, float b) {
  constexpr float glare = 0.05f;
  return (std::max(a, b) + glare) / (std::min(a, b) + glare);
}

/// Calls see(luminance) for the darkest and the lightest of some 16 × 16 parts of the texture.
template <typename See>
void see_extremes(const Texture& texture, float base, const See& see) {
  constexpr int parts = 16;
  int index = 0;
  while (texture.level(index).width() > parts || texture.level(index).height() > parts) ++index;
  const Image<glm::vec4>& level = texture.level(index);
  float darkest = luminance(level.at(0, 0)), lightest = darkest;
  for (int y = 0; y < level.height(); ++y) {
    for (int x = 0; x < level.width(); ++x) {
      darkest = std::min(darkest, luminance(level.at(x, y)));
      lightest = std::max(lightest, luminance(level.at(x, y)));
    }
  }
  see(base * darkest);
  see(base * lightest);
}

/// Calls see(luminance) for all that lines should stand out from.
template <typename See>
void see_all(const Scene& scene, const Rgba8& background, const See& see) {
  if (background.a >= 128) see(luminance(linear_from_srgb(background)));
  const auto& materials = scene.materials();
  // The first is the default one, which hardly shows where there are others.
  for (std::size_t i = materials.size() > 1 ? 1 : 0; i < materials.size(); ++i) {
    const float base = luminance(glm::vec4(materials[i].base_colour, 1.0f));
    if (materials[i].texture) {
      see_extremes(*materials[i].texture, base, see);
    } else {
      see(base);
    }
  }
}

}  // namespace

glm::vec4 wireframe_ink(const Scene& scene, const Rgba8& background) {
  constexpr float unseen = 100.0f;
  const std::array<glm::vec4, 3> inks{glm::vec4(0, 0, 0, 1), glm::vec4(1, 1, 1, 1),
                                      glm::vec4(0.6f, 0.04f, 0, 1)};
  std::array<float, 3> least{unseen, unseen, unseen};
  see_all(scene, background, [&](float below) {
    for (std::size_t i = 0; i < inks.size(); ++i) {
      least[i] = std::min(least[i], contrast(luminance(inks[i]), below));
    }
  });
  return inks[static_cast<std::size_t>(std::max_element(least.begin(), least.end()) - least.begin())];
}

}  // namespace velum
