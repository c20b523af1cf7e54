#pragma once

#include <string>
#include <velum/velum.hpp>

namespace velum_docs {

/// What the page follows: one triangle of the house, seen by one camera on a very small picture.
struct Subject {
  velum::Scene scene;
  velum::Camera camera;
  velum::RenderSettings settings;
  velum::ViewingTransform viewing;
  velum::TriangleTrace triangle;
  velum::ClipTrace clip;
  velum::PixelExplanation pixel;  ///< a pixel that the triangle covers but does not win
  std::string options;            ///< input and camera as they stand on the command line

  velum::Viewport viewport() const { return {settings.width, settings.height}; }
};

Subject make_subject();

}  // namespace velum_docs
