#include "subject.hpp"

#include <algorithm>

#include "meshes.hpp"

namespace velum_bench {
namespace {

using namespace velum;

Subject sphere_subject(std::string name, double triangles) {
  constexpr int width = 1920, height = 1080;
  Mesh mesh = sphere_of(triangles);
  Scene scene;
  scene.add(mesh);
  const Camera camera = Camera::perspective(Pose::towards({1.2, 0.9, 2.4}, {0, 0, 0}, {0, 1, 0}),
                                            {VerticalAngle{0.8}}, 0.1, 10.0);
  const ViewingTransform viewing = camera.viewing_transform(static_cast<double>(width) / height);
  const glm::dmat4 clip_from_object = viewing.clip_from_object(glm::dmat4(1.0));
  return {std::move(name), std::move(mesh), std::move(scene), camera, clip_from_object, {width, height}};
}

}  // namespace

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all{sphere_subject("tiny", 1e6), sphere_subject("small", 7e4),
                                        sphere_subject("large", 2e3)};
  return all;
}

void assemble_and_set_up(const ClipVertices& vertices, const Subject& subject,
                         std::vector<ScreenTriangle>& out) {
  Counters counters;
  for (std::uint32_t i = 0; i < subject.mesh.triangles.size(); ++i) {
    const AssembledTriangle triangle =
        assemble(vertices, subject.mesh.triangles[i], false, Cull::none, {}, counters);
    if (triangle.fate == TriangleFate::accepted) set_up(triangle, i, subject.viewport, counters, out);
  }
}

std::vector<ScreenTriangle> set_up_by_reference(const Subject& subject) {
  ClipVertices vertices;
  transform_vertices(subject.mesh.positions.span(), subject.clip_from_object, vertices);
  std::vector<ScreenTriangle> triangles;
  assemble_and_set_up(vertices, subject, triangles);
  return triangles;
}

std::vector<Isa> measured_isas() {
  std::vector<Isa> isas = available_isas();
  std::stable_partition(isas.begin(), isas.end(), [](Isa isa) { return isa == Isa::reference; });
  return isas;
}

}  // namespace velum_bench
