// Inside another program: the mesh views the caller's arrays, the picture fills the caller's memory, and the
// camera is the caller's own clip matrix (here OpenGL's: depth -1 … 1). Nothing is copied.
#include <array>
#include <cstdint>
#include <iostream>
#include <vector>
#include <velum/velum.hpp>

namespace {

// A scene as an engine might hold it: one quadrilateral of two triangles in the plane z = -5.
const std::array<glm::vec3, 4> positions{glm::vec3{-1.0f, -1.0f, -5.0f}, glm::vec3{1.0f, -1.0f, -5.0f},
                                         glm::vec3{1.0f, 1.0f, -5.0f}, glm::vec3{-1.0f, 1.0f, -5.0f}};
const std::array<glm::uvec3, 2> triangles{glm::uvec3{0, 1, 2}, glm::uvec3{0, 2, 3}};

velum::Mesh view_of_engine_mesh() {
  velum::Mesh mesh;
  mesh.name = "quadrilateral";
  mesh.positions = velum::Array<glm::vec3>::viewing(positions);
  mesh.triangles = velum::Array<glm::uvec3>::viewing(triangles);
  return mesh;
}

/// glFrustum(-1, 1, -1, 1, 1, 10), column after column.
glm::dmat4 engine_clip_matrix() {
  return {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -11.0 / 9.0, -1}, {0, 0, -20.0 / 9.0, 0}};
}

}  // namespace

int main() {
  constexpr int width = 200;
  constexpr int height = 200;
  constexpr int padded_row = 256;  // the engine's rows are longer than the picture is wide
  std::vector<velum::Rgba8> colour(padded_row * height);
  std::vector<float> metric_depth(padded_row * height);

  velum::Scene scene;
  scene.add(view_of_engine_mesh());
  const velum::Camera camera =
      velum::Camera::from_clip_matrix(engine_clip_matrix(), velum::DepthRange::minus_one_to_one);

  velum::PictureTarget target;
  target.colour = {colour.data(), width, height, padded_row};
  target.metric_depth = {metric_depth.data(), width, height, padded_row};

  velum::RenderSettings settings;
  settings.width = width;
  settings.height = height;
  velum::Renderer renderer;  // keeps its buffers from frame to frame
  const velum::Counters counters = renderer.render_into(scene, camera, settings, target);

  const float depth_in_the_middle = target.metric_depth.at(width / 2, height / 2);
  std::cout << counters.pixels_shaded << " pixels, depth in the middle " << depth_in_the_middle << '\n';
  // The quadrilateral spans a fifth of the picture in each direction, 5 units before the camera.
  const bool right =
      counters.pixels_shaded == 40u * 40u && depth_in_the_middle > 4.9999f && depth_in_the_middle < 5.0001f;
  return right ? 0 : 1;
}
