#pragma once

#include <velum/velum.hpp>

inline glm::dmat4 moved(const glm::dvec3& by) {
  glm::dmat4 m(1.0);
  m[3] = glm::dvec4(by, 1.0);
  return m;
}

/// Several solids that overlap in the picture, one of them mirrored and one turned.
inline velum::Scene solids(const glm::dvec3& offset) {
  namespace shapes = velum::shapes;
  velum::Scene scene;
  scene.add(shapes::letter_f(), moved(offset));
  glm::dmat4 mirrored = moved(offset + glm::dvec3(0.4, 0.1, -0.3));
  mirrored[0] = {-0.7, 0.0, 0.2, 0.0};
  scene.add(shapes::house(), mirrored);
  glm::dmat4 turned = moved(offset + glm::dvec3(-0.3, -0.2, 0.2));
  turned[0] = {0.36, 0.48, -0.8, 0.0};
  turned[1] = {-0.8, 0.6, 0.0, 0.0};
  turned[2] = {0.48, 0.64, 0.6, 0.0};
  scene.add(shapes::torus(0.5f, 0.15f, 12, 8), turned);
  return scene;
}
