#include "subjects.hpp"

#include <algorithm>
#include <cmath>

#include "measure.hpp"

namespace velum_claims {
namespace {

using namespace velum;

/// Hills over a square of side 2.
Mesh hills(int cells) {
  Mesh flat = shapes::grid(2.0f, cells);
  std::vector<glm::vec3> positions(flat.positions.begin(), flat.positions.end());
  for (glm::vec3& p : positions) {
    const double x = p.x, z = p.z;
    p.y = static_cast<float>(0.15 * elementary::sin(5.0 * x + 1.0) * elementary::cos(4.0 * z) +
                             0.03 * elementary::sin(17.0 * x - 11.0 * z));
  }
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.triangles = flat.triangles;
  return mesh;
}

glm::dmat4 placed(const glm::dvec3& at, double size) {
  glm::dmat4 m(size);
  m[3] = glm::dvec4(at, 1.0);
  return m;
}

/// A room, open towards +z, with shapes all over it.
Scene room(int shapes_in_it) {
  Scene scene;
  const std::uint32_t things[] = {scene.add_mesh(shapes::icosphere(1.0f, 2)),
                                  scene.add_mesh(shapes::torus(0.75f, 0.25f, 24, 12)),
                                  scene.add_mesh(shapes::cube(1.2f)), scene.add_mesh(shapes::cone())};
  const std::uint32_t wall = scene.add_mesh(shapes::cube(1.0f));
  Numbers numbers{5};
  for (int i = 0; i < shapes_in_it; ++i) {
    const glm::dvec3 at = numbers.point() * glm::dvec3(2.6, 1.8, 2.6);
    scene.add_instance({things[i % 4], 0, placed(at, 0.06 + 0.12 * numbers.next()), ""});
  }
  for (const auto& [at, size] : {std::pair{glm::dvec3(0, -2.05, 0), glm::dvec3(6, 0.1, 6)},
                                 std::pair{glm::dvec3(0, 0, -3.05), glm::dvec3(6, 4, 0.1)},
                                 std::pair{glm::dvec3(-3.05, 0, 0), glm::dvec3(0.1, 4, 6)}}) {
    glm::dmat4 m(1.0);
    for (int axis = 0; axis < 3; ++axis) m[axis][axis] = size[axis];
    m[3] = glm::dvec4(at, 1.0);
    scene.add_instance({wall, 0, m, ""});
  }
  return scene;
}

}  // namespace

void Triangles::add(const Mesh& mesh, const glm::dmat4& world_from_object) {
  const auto first = static_cast<std::uint32_t>(positions.size());
  for (const glm::vec3& p : mesh.positions) {
    positions.emplace_back(glm::dvec3(world_from_object * glm::dvec4(glm::dvec3(p), 1.0)));
  }
  for (const glm::uvec3& t : mesh.triangles) triangles.push_back(t + first);
}

Subject subject_of(const std::string& name, Scene scene) {
  Subject subject{name, std::move(scene), {}};
  for (const Instance& instance : subject.scene.instances()) {
    subject.world.add(subject.scene.meshes()[instance.mesh], instance.world_from_object);
  }
  return subject;
}

std::vector<Subject> built_in_subjects(bool is_quick) {
  std::vector<Subject> subjects;
  Scene torus, land;
  torus.add(shapes::torus(0.75f, 0.25f, is_quick ? 24 : 128, is_quick ? 12 : 64));
  land.add(hills(is_quick ? 12 : 100));
  subjects.push_back(subject_of("torus", std::move(torus)));
  subjects.push_back(subject_of("hills", std::move(land)));
  subjects.push_back(subject_of("room full of shapes", room(is_quick ? 5 : 80)));
  return subjects;
}

Camera camera_of(const Subject& subject, double aspect) {
  FrameOptions options;
  options.aspect = aspect;
  options.z_up = subject.scene.up == UpAxis::z;
  return frame(subject.scene.points(), parse_projection("perspective"), options);
}

Mesh sphere_of(double triangles) {
  // Two triangles per cell, but one at the poles: 2 · segments · (rings - 1).
  const int rings = std::max(2, static_cast<int>(std::lround(std::sqrt(triangles) / 2.0)));
  const int segments = std::max(3, static_cast<int>(std::lround(triangles / (2.0 * (rings - 1)))));
  return shapes::sphere(1.0f, segments, rings);
}

}  // namespace velum_claims
