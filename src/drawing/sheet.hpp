#pragma once

#include <string>
#include <vector>

#include "../base/rect.hpp"
#include "../image/colour.hpp"
#include "../image/image.hpp"
#include "../pipeline/settings.hpp"
#include "../projection/camera.hpp"
#include "../scene/scene.hpp"

namespace velum {

/// Which views stand on a sheet.
enum class SheetLayout {
  four,  ///< front, top and right, and a perspective in the free quadrant
  six,   ///< all principal views
};

/// Where views stand about the front view (ISO 5456-2). First angle: the top view below it, the left view to
/// its right. Third angle: the reverse.
enum class SheetAngle { first, third };

struct SheetOptions {
  SheetLayout layout = SheetLayout::six;
  SheetAngle angle = SheetAngle::first;
  int width = 1200;  ///< pixels of the whole sheet
  int height = 900;
  Rgba8 background{255, 255, 255, 255};
  Shading shading = Shading::phong;
};

/// One view of a sheet.
struct SheetView {
  std::string name;              ///< as in the catalogue: "front", "top", …
  Rect rect;                     ///< its pixels on the sheet
  Camera camera;                 ///< for a picture of rect's size
  double pixels_per_unit = 0.0;  ///< the common scale; 0 for the perspective view
};

/// A sheet of views: the orthographic ones in one common scale and in line with each other, named.
struct Sheet {
  Image<Rgba8> picture;
  std::vector<SheetView> views;
  double pixels_per_unit = 0.0;
};

/// The views' places and cameras without drawing them.
/// @throws Error (usage) if the sheet is too small to hold them
std::vector<SheetView> place_views(const Scene& scene, const SheetOptions& options);

/// Renders every view in its place, with its name below it and the scale.
/// @throws Error (usage) if the sheet is too small to hold them; (limit) if it does not fit into half of the
/// machine's memory
Sheet draw_sheet(const Scene& scene, const SheetOptions& options);

}  // namespace velum
