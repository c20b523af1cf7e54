#include "line_options.hpp"

namespace velum_app {

void LineOptions::add_to(CLI::App& parser) {
  parser.add_option("--line-width", line_width, "Of segments and of the wireframe (default: 1)")
      ->type_name("PIXELS");
  parser.add_option("--point-size", point_size, "Side of the square a point is drawn as (default: 3)")
      ->type_name("PIXELS");
}

void LineOptions::apply_to(velum::RenderSettings& settings) const {
  settings.line_width = line_width;
  settings.point_size = point_size;
}

}  // namespace velum_app
