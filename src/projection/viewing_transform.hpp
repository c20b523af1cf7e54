#pragma once

#include <array>
#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace velum {

/// One factor of a composite viewing matrix.
struct Stage {
  std::string_view
      name;  ///< literal text, as in the lecture, e.g. "T(-COP)", "M_rot^T", "S_xy", "S_xyz(1/far)", "D"
  std::string_view meaning;  ///< one sentence, literal text
  glm::dmat4 matrix{1.0};
};

/// The stages of one viewing transform. It needs no memory beyond itself, so that a camera may move from
/// frame to frame without an allocation.
class StageList {
 public:
  /// As many as any lens has: with a shear of the lens, six.
  static constexpr std::size_t capacity = 6;

  StageList() = default;
  StageList(std::initializer_list<Stage> stages) {
    for (const Stage& stage : stages) push_back(stage);
  }
  /// @pre size() < capacity
  void push_back(const Stage& stage);

  std::size_t size() const { return size_; }
  const Stage& operator[](std::size_t i) const { return stages_[i]; }
  const Stage* begin() const { return stages_.data(); }
  const Stage* end() const { return stages_.data() + size_; }

 private:
  std::array<Stage, capacity> stages_;
  std::size_t size_ = 0;
};

/// The way from world space into the canonical view volume, as a list of named stages in the order of
/// application. Homogeneous clip space: -w ≤ x ≤ w, -w ≤ y ≤ w, 0 ≤ z ≤ w; z = 0 near, z = w far.
class ViewingTransform {
 public:
  ViewingTransform() = default;
  explicit ViewingTransform(const StageList& stages) : stages_(stages) {}

  const StageList& stages() const { return stages_; }

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
  StageList stages_;
};

/// Where the projectors come from, homogeneous: (COP, 1), or (-DOP, 0) for parallel projections; the kernel
/// of rows x, y, w of the matrix. Scaled so that w = 1, or to unit length with the viewer's side positive. A
/// triangle with plane π faces the viewer if π·e > 0, in every projection.
glm::dvec4 eye_of(const glm::dmat4& clip_from_world);

}  // namespace velum
