#include "round_shapes.hpp"

#include <array>

namespace velum_app {

using namespace velum;

const RoundShape& round_shape(const std::string& input) {
  static const std::array<RoundShape, 3> shapes{{
      {"builtin:sphere", [](int k) { return shapes::sphere(1.0f, 48 * k, 24 * k); }, Sphere{}},
      {"builtin:icosphere", [](int k) { return shapes::icosphere(1.0f, k == 4 ? 5 : 2 + k); }, Sphere{}},
      {"builtin:cylinder", [](int k) { return shapes::cylinder(0.5f, 1.0f, 48 * k); },
       Cylinder{{0.0, -0.5, 0.0}, {0.0, 0.5, 0.0}, 0.5}},
  }};
  for (const RoundShape& shape : shapes) {
    if (input == shape.name) return shape;
  }
  throw Error(ErrorKind::usage, "no equation is known for it", input,
              "--analytic takes builtin:sphere, builtin:icosphere or builtin:cylinder");
}

}  // namespace velum_app
