#include "../visibility/zbuffer.hpp"
#include "stages.hpp"

namespace velum {

RasterCounts rasterize(std::span<const ScreenTriangle> triangles, const RasterTarget& target,
                       const RenderSettings& settings, ScanlineTables& tables) {
  switch (settings.visibility) {
    case VisibilityMethod::scanline:
      return rasterize_scanline(triangles, target, settings.z_interpolation, tables);
    case VisibilityMethod::raycast:  // what it leaves to the raster: segments and points
    case VisibilityMethod::zbuffer:
    case VisibilityMethod::hierarchical:
      break;
  }
  return rasterize_zbuffer(triangles, target);
}

}  // namespace velum
