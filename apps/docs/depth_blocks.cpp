// What each depth format can tell apart, over distance; and what happens where it cannot.
#include "blocks.hpp"
#include "depth_formats.hpp"
#include "table.hpp"
#include "text.hpp"

namespace velum_docs {
namespace {

using namespace velum;
using velum_app::grouped_text;
using velum_app::number_text;

std::vector<std::string> format_header(const std::string& first) {
  std::vector<std::string> header{first};
  for (const NamedFormat& named : depth_formats) header.push_back(std::string("`") + named.name + "`");
  return header;
}

/// A length in world units: two digits, and no more than a picture could ever show.
std::string step_text(double step) {
  if (step < 1e-9) return "< 1e-9";
  return step >= 10.0 ? velum_app::fixed_text(step, 0) : number_text(step, 2);
}

std::string resolution_block(const Camera& camera, std::initializer_list<double> distances) {
  Table table(format_header("distance"));
  for (const double distance : distances) {
    std::vector<std::string> row{number_text(distance)};
    for (const NamedFormat& named : depth_formats)
      row.push_back(step_text(depth_resolution_at(camera, named.format, distance)));
    table.add(row);
  }
  return table.markdown();
}

/// Pixels that show another triangle than with the reversed depth.
std::uint64_t wrong_pixels(const Picture& picture, const Picture& right) {
  std::uint64_t count = 0;
  for (int y = 0; y < picture.triangle_id.height(); ++y) {
    for (int x = 0; x < picture.triangle_id.width(); ++x)
      count += picture.triangle_id.at(x, y) != right.triangle_id.at(x, y);
  }
  return count;
}

std::string fighting_block(const FarHouse& house) {
  Table table(format_header(""));
  const Picture right = render_far_house(house, DepthFormat::reversed);
  std::vector<std::string> wrong{"pixels with another triangle than `reversed`"};
  std::vector<std::string> step{"smallest step at the house, " + number_text(house.distance, 3) +
                                " units away"};
  for (const NamedFormat& named : depth_formats) {
    wrong.push_back(grouped_text(wrong_pixels(render_far_house(house, named.format), right)));
    step.push_back(step_text(depth_resolution_at(house.camera, named.format, house.distance)));
  }
  table.add(step);
  table.add(wrong);
  return table.markdown() + "\n```sh\nvelum render " + house.options +
         " \\\n  --visibility scanline --depth-format 24 -o fighting.png\n```\n";
}

}  // namespace

void add_depth_blocks(Docs& docs) {
  const FarHouse house = make_far_house();
  docs.pictures["fighting.png"] = draw_fighting(house);
  docs.blocks["fighting"] = fighting_block(house);
  const Camera perspective = Camera::perspective({}, {}, 0.01, 1000.0);
  docs.blocks["perspective resolution"] =
      resolution_block(perspective, {0.01, 0.1, 1.0, 10.0, 100.0, 500.0, 1000.0});
  const Camera parallel = Camera::parallel({}, {}, 0.01, 1000.0);
  docs.blocks["parallel resolution"] = resolution_block(parallel, {0.01, 10.0, 100.0, 500.0, 1000.0});
}

}  // namespace velum_docs
