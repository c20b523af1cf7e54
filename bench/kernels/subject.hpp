#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <string>
#include <vector>
#include <velum/pipeline/stages.hpp>
#include <velum/velum.hpp>

namespace velum_bench {

/// What the kernels are measured on: a sphere that nearly fills a picture of 1920×1080, nothing of it
/// clipped.
struct Subject {
  std::string name;
  velum::Mesh mesh;
  velum::Scene scene;  ///< the mesh by itself
  velum::Camera camera;
  glm::dmat4 clip_from_object;
  velum::Viewport viewport;

  velum::Rect rect() const { return {0, 0, viewport.width, viewport.height}; }
};

/// By the size of its triangles: "tiny" about a pixel, "small" a few, "large" some hundreds of them.
const std::vector<Subject>& subjects();

/// Appends every triangle of the subject, assembled and set up by the plain stages.
void assemble_and_set_up(const velum::ClipVertices& vertices, const Subject& subject,
                         std::vector<velum::ScreenTriangle>& out);
/// The same from its positions.
std::vector<velum::ScreenTriangle> set_up_by_reference(const Subject& subject);

/// "best" left out: every instruction set that this machine has, the reference first.
std::vector<velum::Isa> measured_isas();

/// Registers run(state, subject, isa) for each subject and instruction set, as kernel/subject/isa.
template <typename Run>
void register_kernel(const std::string& kernel, const Run& run) {
  for (const Subject& subject : subjects()) {
    for (const velum::Isa isa : measured_isas()) {
      const std::string name = kernel + "/" + subject.name + "/" + velum::name_of(isa);
      benchmark::RegisterBenchmark(
          name.c_str(), [&subject, isa, run](benchmark::State& state) { run(state, subject, isa); });
    }
  }
}

/// Shown as items per second.
inline void count_items(benchmark::State& state, std::size_t per_iteration) {
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(per_iteration));
}

}  // namespace velum_bench
