// Depth from the plane, along the edges, and by increments: how far they are apart.
#include <algorithm>
#include <bit>
#include <cmath>

#include "blocks.hpp"
#include "paint.hpp"
#include "pixel_table.hpp"
#include "text.hpp"

namespace velum_docs {
namespace {

using namespace velum;
using velum_app::grouped_text;
using velum_app::number_text;

struct Interpolation {
  const char* name;
  ZInterpolation value;
};
constexpr Interpolation teaching[] = {{"edges", ZInterpolation::edges},
                                      {"incremental", ZInterpolation::incremental}};

/// By how many floats apart: neighbours differ by 1.
std::int64_t steps_between(float a, float b) {
  return std::int64_t{std::bit_cast<std::int32_t>(a)} - std::bit_cast<std::int32_t>(b);
}

std::string difference_block(const Subject& subject, ZInterpolation interpolation) {
  const SpanTable plane(subject), other(subject, interpolation);
  return pixel_table(plane, [&](int x, int y) {
    const std::int64_t steps = steps_between(other.reversed_depth(x, y), plane.reversed_depth(x, y));
    return steps == 0 ? std::string(".") : (steps > 0 ? "+" : "") + std::to_string(steps);
  });
}

/// A scene and how large its picture is.
struct View {
  std::string name;
  Scene scene;
  Camera camera;
  RenderSettings settings;
};

RenderSettings scanline(int width, int height) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.visibility = VisibilityMethod::scanline;
  settings.clip = ClipPolicy::exact;
  settings.shading = Shading::triangle_id;
  return settings;
}

View house_view(const Subject& subject) {
  return {"the house above, 640x480", subject.scene, subject.camera, scanline(640, 480)};
}

View house_from_afar(const Subject& subject) {
  FrameOptions options;
  options.aspect = 4.0 / 3.0;
  options.eye = glm::dvec3(170.0, 130.0, 240.0);
  options.near = 0.1;
  options.far = 1000.0;
  const Camera camera = frame(subject.scene.points(), projection::perspective(), options);
  return {"the house from 321 units away, near 0.1, far 1000", subject.scene, camera, scanline(640, 480)};
}

View torus_view() {
  Scene scene = load_scene("builtin:torus");
  FrameOptions options;
  options.aspect = 4.0 / 3.0;
  const Camera camera = frame(scene.points(), projection::isometric(), options);
  return {"a torus of 4096 triangles, isometric, 640x480", std::move(scene), camera, scanline(640, 480)};
}

Picture render_with(const View& view, ZInterpolation interpolation) {
  RenderSettings settings = view.settings;
  settings.z_interpolation = interpolation;
  return render(view.scene, view.camera, settings);
}

struct Difference {
  std::uint64_t seen = 0;        ///< pixels that show a surface
  std::uint64_t other_bits = 0;  ///< of them, with other depth bits
  std::uint64_t other_ids = 0;   ///< of them, that show another triangle
  double largest = 0.0;          ///< of z
};

Difference difference_of(const Picture& plane, const Picture& other) {
  Difference d;
  for (int y = 0; y < plane.depth.height(); ++y) {
    for (int x = 0; x < plane.depth.width(); ++x) {
      if (plane.triangle_id.at(x, y) == no_primitive) continue;
      ++d.seen;
      d.other_ids += plane.triangle_id.at(x, y) != other.triangle_id.at(x, y);
      d.other_bits += plane.depth.at(x, y) != other.depth.at(x, y);
      d.largest = std::max(d.largest, std::abs(double{plane.depth.at(x, y)} - other.depth.at(x, y)));
    }
  }
  return d;
}

void add_rows(const View& view, Table& table) {
  const Picture plane = render_with(view, ZInterpolation::plane);
  for (const Interpolation& interpolation : teaching) {
    const Difference d = difference_of(plane, render_with(view, interpolation.value));
    table.add({view.name, std::string("`") + interpolation.name + "`", grouped_text(d.seen),
               grouped_text(d.other_bits), number_text(d.largest, 2), grouped_text(d.other_ids)});
  }
}

std::string measured_block(const Subject& subject) {
  Table table({"scene", "z by", "pixels that show it", "with another z", "largest difference of z",
               "with another triangle"});
  add_rows(house_view(subject), table);
  add_rows(torus_view(), table);
  add_rows(house_from_afar(subject), table);
  return table.markdown();
}

/// Where the house's z differs, each picture on its own scale.
Image<Rgba8> differences_picture(const Subject& subject) {
  View view = house_view(subject);
  view.settings.width = 280;
  view.settings.height = 210;
  const Picture plane = render_with(view, ZInterpolation::plane);
  std::vector<Image<Rgba8>> panels;
  for (const Interpolation& interpolation : teaching) {
    const Picture other = render_with(view, interpolation.value);
    Canvas canvas(view.settings.width, view.settings.height + 24, paper);
    canvas.text({2, 5}, interpolation.name, 2, ink);
    paint_image(canvas, heat_map(plane.depth.view(), other.depth.view()), 0, 24);
    panels.push_back(canvas.picture());
  }
  return side_by_side(panels, 8);
}

}  // namespace

void add_interpolation(const Subject& subject, Docs& docs) {
  docs.blocks["z by edges"] = difference_block(subject, ZInterpolation::edges);
  docs.blocks["z by increments"] = difference_block(subject, ZInterpolation::incremental);
  docs.blocks["measured"] = measured_block(subject);
  docs.pictures["interpolation.png"] = differences_picture(subject);
}

}  // namespace velum_docs
