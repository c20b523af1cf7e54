#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

namespace velum {

/// One factor of a composite viewing matrix.
struct Stage {
  std::string name;     ///< as in the lecture, e.g. "T(-COP)", "M_rot^T", "S_xy", "S_xyz(1/far)", "D"
  std::string meaning;  ///< one sentence
  glm::dmat4 matrix{1.0};
};

/// The way from world space into the canonical view volume, as a list of named stages in the order of
/// application. Homogeneous clip space: -w ≤ x ≤ w, -w ≤ y ≤ w, 0 ≤ z ≤ w; z = 0 near, z = w far.
class ViewingTransform {
 public:
  ViewingTransform() = default;
  explicit ViewingTransform(std::vector<Stage> stages);

  const std::vector<Stage>& stages() const { return stages_; }

  /// The product of all stages.
  glm::dmat4 clip_from_world() const { return clip_from_object(glm::dmat4(1.0)); }
  /// The stages applied to a model matrix one after the other, so that a translation far from the origin
  /// cancels in the first product, before anything is scaled.
  glm::dmat4 clip_from_object(const glm::dmat4& world_from_object) const;
  /// The inverse of the product. @throws Error (usage) if it is singular
  glm::dmat4 world_from_clip() const;

  /// The images of a homogeneous point: first the point itself, then after each stage. Size: stages() + 1.
  std::vector<glm::dvec4> images_of(const glm::dvec4& world_point) const;

 private:
  std::vector<Stage> stages_;
};

/// Where the projectors come from, homogeneous: (COP, 1), or (-DOP, 0) for parallel projections; the kernel
/// of rows x, y, w of the matrix. Scaled so that w = 1, or to unit length with the viewer's side positive. A
/// triangle with plane π faces the viewer if π·e > 0, in every projection.
glm::dvec4 eye_of(const glm::dmat4& clip_from_world);

}  // namespace velum
