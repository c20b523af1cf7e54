#include "agree_analytic_text.hpp"

#include <array>
#include <iostream>
#include <velum/pipeline/agree_analytic.hpp>

#include "json_values.hpp"
#include "round_shapes.hpp"
#include "text.hpp"
#include "verb.hpp"

namespace velum_app {
namespace {

using namespace velum;

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
  const RoundShape& shape = round_shape(input);
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
