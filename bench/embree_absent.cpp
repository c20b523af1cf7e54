// Takes embree.cpp's place where Embree is not installed.
#include <stdexcept>

#include "embree.hpp"

namespace velum_bench {

struct EmbreeScene::State {};

bool has_embree() {
  return false;
}
std::vector<FloatRay> float_rays(const std::vector<velum::ViewRay>&) {
  return {};
}
EmbreeScene::EmbreeScene(const velum::Mesh&, bool) {
  throw std::runtime_error("built without Embree");
}
EmbreeScene::~EmbreeScene() = default;
void EmbreeScene::build() {}
std::int64_t EmbreeScene::memory() const {
  return 0;
}
void EmbreeScene::first_hits(const std::vector<FloatRay>&, std::vector<std::uint32_t>&) const {}
void EmbreeScene::first_hits_by_eight(const std::vector<FloatRay>&, std::vector<std::uint32_t>&) const {}
void EmbreeScene::any_hits(const std::vector<FloatRay>&, std::vector<std::uint32_t>&) const {}

}  // namespace velum_bench
