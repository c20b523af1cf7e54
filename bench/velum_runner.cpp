#include "velum_runner.hpp"

namespace velum_bench {

using namespace velum;

std::vector<Mode> modes() {
  return {{"zbuffer", VisibilityMethod::zbuffer, true, false},
          {"hierarchical", VisibilityMethod::hierarchical, true, false},
          {"ids", VisibilityMethod::zbuffer, true, true},
          {"depth", VisibilityMethod::zbuffer, false, false},
          {"scanline", VisibilityMethod::scanline, true, false},
          {"raycast", VisibilityMethod::raycast, true, false}};
}

Mode mode_named(const std::string& name) {
  for (const Mode& mode : modes()) {
    if (mode.name == name) return mode;
  }
  throw Error(ErrorKind::usage, "there is no mode \"" + name + "\"", "--mode", "see --help for their names");
}

std::string default_mode(const std::string& scene) {
  return scene.ends_with("s1000") ? "hierarchical" : "zbuffer";
}

VelumRunner::VelumRunner(const BenchScene& bench, const Mode& mode, const VelumOptions& options)
    : bench_(bench), depth_(bench.width, bench.height) {
  target_.depth = depth_.view();
  if (mode.colour) {
    colour_ = Image<Rgba8>(bench.width, bench.height);
    target_.colour = colour_.view();
  }
  if (mode.ids) {
    ids_ = Image<std::uint32_t>(bench.width, bench.height);
    target_.triangle_id = ids_.view();
  }
  settings_.width = bench.width;
  settings_.height = bench.height;
  settings_.visibility = mode.method;
  settings_.shading = options.shading;
  settings_.threads = options.threads;
  settings_.isa = options.isa;
}

void VelumRunner::draw() {
  counters_ = renderer_.render_into(bench_.scene, bench_.camera, settings_, target_);
}

std::vector<std::uint8_t> VelumRunner::coverage() {
  Image<std::uint32_t> ids(bench_.width, bench_.height);
  renderer_.render_into(bench_.scene, bench_.camera, settings_, {.triangle_id = ids.view()});
  std::vector<std::uint8_t> covered;
  covered.reserve(static_cast<std::size_t>(bench_.pixels()));
  for (int y = 0; y < bench_.height; ++y) {
    for (int x = 0; x < bench_.width; ++x) covered.push_back(ids.at(x, y) != 0xFFFFFFFFu);
  }
  return covered;
}

}  // namespace velum_bench
