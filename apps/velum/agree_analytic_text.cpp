#include "agree_analytic_text.hpp"

#include <array>
#include <iostream>
#include <velum/pipeline/agree_analytic.hpp>

#include "json_values.hpp"
#include "text.hpp"
#include "verb.hpp"

namespace velum_app {
namespace {

using namespace velum;

/// A built-in shape, as fine as its default times a factor, and what it stands for.
struct Round {
  const char* name;
  Mesh (*mesh)(int factor);
  AnalyticBody body;
};

const std::array<Round, 3>& round_shapes() {
  static const std::array<Round, 3> shapes{{
      {"builtin:sphere", [](int k) { return shapes::sphere(1.0f, 48 * k, 24 * k); }, Sphere{}},
      {"builtin:icosphere", [](int k) { return shapes::icosphere(1.0f, k == 4 ? 5 : 2 + k); }, Sphere{}},
      {"builtin:cylinder", [](int k) { return shapes::cylinder(0.5f, 1.0f, 48 * k); },
       Cylinder{{0.0, -0.5, 0.0}, {0.0, 0.5, 0.0}, 0.5}},
  }};
  return shapes;
}

const Round& round_shape(const std::string& input) {
  for (const Round& shape : round_shapes()) {
    if (input == shape.name) return shape;
  }
  throw Error(ErrorKind::usage, "no equation is known for it", input,
              "--analytic takes builtin:sphere, builtin:icosphere or builtin:cylinder");
}

Json json_of(const AnalyticAgreement& agreement, std::size_t triangles) {
  return {{"triangles", triangles},
          {"covered", agreement.covered},
          {"silhouette", agreement.silhouette},
          {"unexplained", agreement.unexplained},
          {"bound", 1.0 - agreement.inner_share}};
}

void print_line(const AnalyticAgreement& agreement, std::size_t triangles) {
  std::cout << "  " << padded_left(counted_text(triangles, "triangle"), 18) << ": "
            << counted_text(agreement.silhouette, "pixel") << " of " << grouped_text(agreement.covered)
            << " differ at the silhouette, " << grouped_text(agreement.unexplained)
            << " unexplained; the ring is " << percent_text(1.0 - agreement.inner_share)
            << " of the radius wide\n";
}

}  // namespace

int agree_with_equation(const std::string& input, const View& view, const RenderSettings& settings,
                        bool json) {
  const Round& shape = round_shape(input);
  Json rows = Json::array();
  bool is_explained = true;
  if (!json) std::cout << input << " against its equation, by object id:\n";
  for (const int factor : {1, 2, 4}) {
    Scene scene;
    scene.add(shape.mesh(factor));
    scene.up = view.up_axis();
    const Camera camera = frame(scene.points(), view.projection, view.framing);
    const AnalyticAgreement agreement = agree_analytic(scene, std::array{shape.body}, camera, settings);
    const std::size_t triangles = scene.meshes()[0].triangles.size();
    is_explained = is_explained && agreement.unexplained == 0;
    rows.push_back(json_of(agreement, triangles));
    if (!json) print_line(agreement, triangles);
  }
  if (json) std::cout << json_text({{"input", input}, {"tessellations", rows}});
  return is_explained ? exit_ok : exit_different;
}

}  // namespace velum_app
