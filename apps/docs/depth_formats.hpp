#pragma once

#include <string>
#include <velum/velum.hpp>

namespace velum_docs {

struct NamedFormat {
  const char* name;  ///< as --depth-format has it
  velum::DepthFormat format;
};
inline constexpr NamedFormat depth_formats[] = {{"reversed", velum::DepthFormat::reversed},
                                                {"float", velum::DepthFormat::float_z},
                                                {"24", velum::DepthFormat::z24},
                                                {"16", velum::DepthFormat::z16},
                                                {"8", velum::DepthFormat::z8}};

/// The house from far away, with a near plane that leaves little depth for it.
struct FarHouse {
  velum::Scene scene;
  velum::Camera camera;
  velum::RenderSettings settings;
  double distance = 0.0;  ///< of the house along the look vector
  std::string options;    ///< input and camera as they stand on the command line
};
FarHouse make_far_house();

velum::Picture render_far_house(const FarHouse& house, velum::DepthFormat format);

/// All formats side by side.
velum::Image<velum::Rgba8> draw_fighting(const FarHouse& house);

}  // namespace velum_docs
