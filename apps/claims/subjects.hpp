#pragma once

#include <string>
#include <vector>
#include <velum/raycast/triangle_set.hpp>
#include <velum/velum.hpp>

namespace velum_claims {

/// Triangles in memory of their own.
struct Triangles {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;

  velum::TriangleSet set() const { return {positions, triangles}; }
  void add(const velum::Mesh& mesh, const glm::dmat4& world_from_object = glm::dmat4(1.0));
};

/// A scene that claims are tested on.
struct Subject {
  std::string name;
  velum::Scene scene;
  Triangles world;  ///< of all instances, in world space
};

Subject subject_of(const std::string& name, velum::Scene scene);

/// Built-in shapes: a smooth closed one, hills, many small things in a room.
std::vector<Subject> built_in_subjects(bool is_quick);

/// Seen from the front, a little from above, framed. @param aspect width / height
velum::Camera camera_of(const Subject& subject, double aspect);

/// A sphere of about so many triangles.
velum::Mesh sphere_of(double triangles);

}  // namespace velum_claims
