#include "kernels.hpp"
#include "subject.hpp"

namespace velum_bench {
namespace {

using namespace velum;

void draw_frames(benchmark::State& state, const Subject& subject, Isa isa) {
  RenderSettings settings;
  settings.width = subject.viewport.width;
  settings.height = subject.viewport.height;
  settings.shading = Shading::triangle_id;
  settings.threads = 1;
  settings.isa = isa;
  Image<Rgba8> colour(settings.width, settings.height);
  Image<float> depth(settings.width, settings.height);
  const PictureTarget target{.colour = colour.view(), .depth = depth.view()};
  Renderer renderer;
  for (auto _ : state) {
    renderer.render_into(subject.scene, subject.camera, settings, target);
    benchmark::ClobberMemory();
  }
  count_items(state, subject.mesh.triangles.size());
}

}  // namespace

void register_frame() {
  register_kernel("frame", draw_frames);
}

}  // namespace velum_bench
