#include <memory>
#include <string_view>

#include "scene_geometry.hpp"

namespace golden {
namespace {

using namespace velum;

/// One texel per character, rows top to bottom, for a picture in which every mirroring shows.
std::shared_ptr<const Texture> painted(std::string_view rows, int width) {
  const int height = static_cast<int>(rows.size()) / width;
  Image<Rgba8> picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const char sign = rows[static_cast<std::size_t>(y * width + x)];
      picture.at(x, y) = sign == 'r'   ? Rgba8{220, 30, 20, 255}
                         : sign == 'b' ? Rgba8{20, 60, 210, 255}
                         : sign == 'k' ? Rgba8{25, 25, 25, 255}
                         : sign == '.' ? Rgba8{255, 255, 255, 0}
                                       : Rgba8{240, 240, 230, 255};
    }
  }
  return std::make_shared<const Texture>(picture);
}

std::uint32_t paper(Scene& scene, std::shared_ptr<const Texture> texture, TextureWrap wrap,
                    const TextureMapping& mapping) {
  Material material;
  material.base_colour = glm::vec3(1.0f);
  material.specular = glm::vec3(0.0f);
  material.texture = std::move(texture);
  material.texture_mapping = mapping;
  material.texture_mapping.wrap = {wrap, wrap};
  return scene.add_material(material);
}

/// A sheet from a corner along two edges; the texture stands upright on it.
Mesh sheet(const glm::vec3& corner, const glm::vec3& across, const glm::vec3& up) {
  Mesh mesh;
  mesh.positions = std::vector<glm::vec3>{corner, corner + across, corner + across + up, corner + up};
  mesh.texture_coordinates = std::vector<glm::vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

}  // namespace

Scene textured() {
  Scene scene;
  const auto checks = painted("wkkw", 2);
  TextureMapping tiles;
  tiles.scale = glm::vec2(4.0f, 12.0f);
  scene.add(sheet({-2.0f, 0.0f, 2.0f}, {4.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -12.0f}), glm::dmat4(1.0),
            paper(scene, checks, TextureWrap::repeat, tiles));
  // An F, 5 x 7 texels, with a blue corner and a hole.
  const auto letter = painted("bwwwwwrrrwwrw.wwrrwwwrwwwwrwwwwwwww", 5);
  TextureMapping beyond;
  beyond.scale = glm::vec2(2.0f);
  beyond.offset = glm::vec2(-0.5f);
  const TextureWrap wraps[] = {TextureWrap::repeat, TextureWrap::clamp, TextureWrap::mirror};
  for (int i = 0; i < 3; ++i) {
    const auto step = static_cast<float>(i);
    scene.add(sheet({-1.9f + 1.3f * step, 0.1f, 1.0f - step}, {1.1f, 0.0f, -0.4f}, {0.0f, 1.6f, 0.0f}),
              glm::dmat4(1.0), paper(scene, letter, wraps[i], beyond));
  }
  return scene;
}

}  // namespace golden
