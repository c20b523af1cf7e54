#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "../image/image.hpp"
#include "../projection/camera.hpp"
#include "../scene/scene.hpp"
#include "classify_difference.hpp"
#include "settings.hpp"

namespace velum {

/// A pixel that two methods see differently.
struct Difference {
  int x = 0;  ///< of the whole picture
  int y = 0;
  std::uint32_t raster = 0;  ///< primitive id, or no_primitive
  std::uint32_t ray = 0;
  Agreement reason = Agreement::unexplained;
};

/// Two answers to "which surface is seen?", compared pixel by pixel.
struct AgreementReport {
  std::array<std::uint64_t, agreement_count> counts{};  ///< pixels per class, by Agreement
  std::uint64_t pixels = 0;
  std::uint64_t covered = 0;            ///< pixels where at least one of them sees something
  Image<std::uint8_t> classes;          ///< Agreement, per pixel
  std::vector<Difference> differences;  ///< all but `same`, row by row

  std::uint64_t of(Agreement agreement) const { return counts[static_cast<std::size_t>(agreement)]; }
  /// The share of the covered pixels that differ, explained or not, 0…1.
  double differing_share() const {
    return covered == 0 ? 0.0 : static_cast<double>(differences.size()) / static_cast<double>(covered);
  }
  bool is_explained() const { return of(Agreement::unexplained) == 0; }
};

/// Renders a scene by the raster and by ray casting and explains where they differ. The two share the scene's
/// triangles and the camera's composite matrix, and nothing else: one projects triangles and scans them, the
/// other intersects them in the scene.
/// @param settings  size, crop, culling, accelerator; visibility and shading are not looked at
/// @throws Error as render()
AgreementReport agree(const Scene& scene, const Camera& camera, const RenderSettings& settings);

/// The same for ids that are there already. @pre both have the size of the picture, or of its crop
AgreementReport compare_visibility(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                                   const Image<std::uint32_t>& raster, const Image<std::uint32_t>& rays);

}  // namespace velum
