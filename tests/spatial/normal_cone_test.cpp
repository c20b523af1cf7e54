#include "spatial/normal_cone.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "random.hpp"

using namespace velum;

TEST_CASE("a normal cone holds every normal of its triangles") {
  Random random{1};
  int valid = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    const double roughness = 0.02 * round;
    for (int i = 0; i < 20; ++i) {
      const auto first = static_cast<std::uint32_t>(positions.size());
      const auto height = [&] { return static_cast<float>(roughness * random.uniform(-1, 1)); };
      const float x = static_cast<float>(random.uniform()), y = static_cast<float>(random.uniform());
      positions.emplace_back(x, y, height());
      positions.emplace_back(x + 1.0f, y, height());
      positions.emplace_back(x, y + 1.0f, height());
      indices.insert(indices.end(), {first, first + 1, first + 2});
    }
    const NormalCone cone = normal_cone(positions, indices);
    if (!cone.is_valid) continue;
    ++valid;
    CHECK(std::abs(glm::dot(cone.axis, cone.axis) - 1.0) < 1e-12);
    CHECK(cone.cosine * cone.cosine + cone.sine * cone.sine == doctest::Approx(1.0));
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      const glm::dvec3 a(positions[i]), b(positions[i + 1]), c(positions[i + 2]);
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      CHECK(glm::dot(normal, cone.axis) >= cone.cosine * glm::length(normal));
      CHECK(glm::length(normal) >= cone.smallest_area);
      CHECK(glm::length(b - a) <= cone.longest_edge);
      CHECK(glm::length(c - b) <= cone.longest_edge);
    }
  }
  CHECK(valid > 50);
}

TEST_CASE("a triangle without area, or normals all around, make no cone") {
  const std::vector<glm::vec3> positions{glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0),
                                         glm::vec3(2, 0, 0)};
  CHECK(normal_cone(positions, std::vector<std::uint32_t>{0, 1, 2}).is_valid);
  CHECK_FALSE(normal_cone(positions, std::vector<std::uint32_t>{0, 1, 2, 0, 1, 3}).is_valid);
  CHECK_FALSE(normal_cone(positions, std::vector<std::uint32_t>{0, 1, 2, 0, 2, 1}).is_valid);
  CHECK_FALSE(normal_cone(positions, {}).is_valid);
}
