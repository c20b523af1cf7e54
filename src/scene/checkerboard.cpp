#include "checkerboard.hpp"

#include <memory>
#include <vector>

#include "builtin.hpp"

namespace velum {
namespace {

constexpr int cells = 256;

/// Two by two cells; repeated, they are the board.
Image<Rgba8> four_cells() {
  constexpr int cell = 64;
  constexpr Rgba8 light{235, 232, 222, 255}, dark{38, 42, 52, 255};
  Image<Rgba8> picture(2 * cell, 2 * cell, light);
  for (int y = 0; y < 2 * cell; ++y) {
    for (int x = 0; x < 2 * cell; ++x) {
      if ((x < cell) != (y < cell)) picture.at(x, y) = dark;
    }
  }
  return picture;
}

}  // namespace

Scene checkerboard_scene() {
  Mesh mesh = shapes::grid(cells, 1);
  mesh.name = "checkerboard";
  std::vector<glm::vec2> coordinates(mesh.texture_coordinates.begin(), mesh.texture_coordinates.end());
  for (glm::vec2& coordinate : coordinates) coordinate *= cells / 2.0f;
  mesh.texture_coordinates = std::move(coordinates);

  Material material;
  material.name = "checkerboard";
  material.base_colour = glm::vec3(1.0f);
  material.specular = glm::vec3(0.0f);
  material.texture = std::make_shared<const Texture>(four_cells());
  Scene scene;
  scene.add(std::move(mesh), glm::dmat4(1.0), scene.add_material(std::move(material)));
  return scene;
}

}  // namespace velum
