#include "viewing_transform.hpp"

#include <cmath>
#include <string>

#include "../base/contract.hpp"
#include "../base/error.hpp"
#include "../base/floating_point.hpp"

namespace velum {

void StageList::push_back(const Stage& stage) {
  VELUM_REQUIRE(size_ < capacity, {"size", size_});
  stages_[size_++] = stage;
}

glm::dmat4 ViewingTransform::clip_from_object(const glm::dmat4& world_from_object) const {
  const FloatingPointScope floating_point;
  glm::dmat4 product = world_from_object;
  for (const Stage& stage : stages_) product = stage.matrix * product;
  return product;
}

glm::dmat4 ViewingTransform::world_from_clip() const {
  const FloatingPointScope floating_point;
  // Inverting each stage by itself keeps a translation far from the origin out of all the other factors.
  glm::dmat4 product(1.0);
  for (const Stage& stage : stages_) {
    const double determinant = glm::determinant(stage.matrix);
    if (determinant == 0.0 || !std::isfinite(determinant)) {
      throw Error(ErrorKind::usage,
                  "the stage \"" + std::string(stage.name) + "\" is singular, so it has no inverse",
                  "viewing transform");
    }
    product = product * glm::inverse(stage.matrix);
  }
  return product;
}

std::vector<glm::dvec4> ViewingTransform::images_of(const glm::dvec4& world_point) const {
  const FloatingPointScope floating_point;
  std::vector<glm::dvec4> images{world_point};
  images.reserve(stages_.size() + 1);
  for (const Stage& stage : stages_) images.push_back(stage.matrix * images.back());
  return images;
}

}  // namespace velum
