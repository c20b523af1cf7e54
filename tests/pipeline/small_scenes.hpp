#pragma once

#include <vector>
#include <velum/velum.hpp>

#include "random.hpp"

namespace velum::test {

inline glm::dmat4 moved(const glm::dvec3& by) {
  glm::dmat4 m(1.0);
  m[3] = glm::dvec4(by, 1.0);
  return m;
}

/// Solids that meet and hide each other, one of them mirrored, and one triangle twice (an exact tie).
inline Scene meeting_solids() {
  Scene scene;
  scene.add(shapes::house());
  scene.add(shapes::torus(0.5f, 0.2f, 12, 8), moved({0.3, 0.2, 0.8}));
  glm::dmat4 mirrored = moved({-0.6, 0.4, 0.5});
  mirrored[0].x = -0.7;
  scene.add(shapes::letter_f(), mirrored);
  Mesh twice;
  twice.positions = {glm::vec3(-0.9f, -0.2f, 0.9f), glm::vec3(0.8f, 0.1f, 0.9f), glm::vec3(0.0f, 1.0f, 0.4f)};
  twice.triangles = {glm::uvec3(0, 1, 2), glm::uvec3(2, 1, 0)};
  scene.add(twice);
  return scene;
}

/// Random triangles, slivers among them, that reach far beyond any picture of the unit cube.
inline Scene random_triangles(std::uint64_t seed, int count) {
  Random random{seed};
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  for (int i = 0; i < count; ++i) {
    const double reach = i % 4 == 0 ? 8.0 : 1.0;
    const auto coordinate = [&] { return static_cast<float>(random.uniform(-reach, reach)); };
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (int corner = 0; corner < 3; ++corner)
      positions.push_back({coordinate(), coordinate(), coordinate()});
    if (i % 5 == 0) positions.back() = positions[first + 1] + glm::vec3(0.003f, 0.002f, 0.0f);
    triangles.push_back({first, first + 1, first + 2});
  }
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(triangles);
  Scene scene;
  scene.add(std::move(mesh));
  return scene;
}

inline RenderSettings size(int width, int height) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  return settings;
}

/// Frames the scene; `eye` puts the camera inside it.
inline Camera camera_of(const Scene& scene, std::string_view projection, const RenderSettings& settings,
                        std::optional<glm::dvec3> eye = {}) {
  FrameOptions options;
  options.aspect = static_cast<double>(settings.width) / settings.height;
  options.eye = eye;
  return frame(scene.bounds(), parse_projection(projection), options);
}

}  // namespace velum::test
