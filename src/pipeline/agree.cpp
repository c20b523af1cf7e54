#include "agree.hpp"

#include "../base/contract.hpp"
#include "../base/floating_point.hpp"
#include "../image/visibility_buffer.hpp"
#include "check_request.hpp"
#include "render.hpp"

namespace velum {
namespace {

Image<std::uint32_t> ids_by(VisibilityMethod method, const Scene& scene, const Camera& camera,
                            RenderSettings settings) {
  settings.visibility = method;
  settings.z_interpolation = ZInterpolation::plane;
  settings.depth_format = DepthFormat::reversed;
  settings.shading = Shading::triangle_id;
  settings.shader = nullptr;
  settings.inlined_shader = {};
  settings.layers = 1;
  return std::move(render(scene, camera, settings).triangle_id);
}

}  // namespace

AgreementReport compare_visibility(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                                   const Image<std::uint32_t>& raster, const Image<std::uint32_t>& rays) {
  const FloatingPointScope floating_point;
  const Rect rect = requested_rect(settings);
  VELUM_REQUIRE(raster.width() == rect.width && raster.height() == rect.height,
                {"raster width", raster.width()}, {"wanted", rect.width});
  VELUM_REQUIRE(rays.width() == rect.width && rays.height() == rect.height, {"rays width", rays.width()},
                {"wanted", rect.width});
  const ViewingTransform viewing = requested_view(camera, settings);
  const DifferenceClassifier classifier(scene, viewing, settings);
  AgreementReport report;
  report.classes.resize(rect.width, rect.height);
  for (int y = 0; y < rect.height; ++y) {
    for (int x = 0; x < rect.width; ++x) {
      const std::uint32_t one = raster.at(x, y), other = rays.at(x, y);
      const Agreement agreement = classifier.classify(rect.left + x, rect.top + y, one, other);
      report.classes.at(x, y) = static_cast<std::uint8_t>(agreement);
      ++report.counts[static_cast<std::size_t>(agreement)];
      ++report.pixels;
      report.covered += one != no_primitive || other != no_primitive;
      if (agreement == Agreement::same) continue;
      report.differences.push_back({rect.left + x, rect.top + y, one, other, agreement});
    }
  }
  return report;
}

AgreementReport agree(const Scene& scene, const Camera& camera, const RenderSettings& settings) {
  return compare_visibility(scene, camera, settings,
                            ids_by(VisibilityMethod::zbuffer, scene, camera, settings),
                            ids_by(VisibilityMethod::raycast, scene, camera, settings));
}

}  // namespace velum
