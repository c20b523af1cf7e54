// Takes llvmpipe.cpp's place where OSMesa is not installed.
#include <stdexcept>

#include "llvmpipe.hpp"

namespace velum_bench {

struct Llvmpipe::State {};

bool has_llvmpipe() {
  return false;
}
void set_llvmpipe_threads(int) {}
Llvmpipe::Llvmpipe(const BenchScene&, bool) {
  throw std::runtime_error("built without OSMesa");
}
Llvmpipe::~Llvmpipe() = default;
void Llvmpipe::draw() {}
std::vector<std::uint8_t> Llvmpipe::coverage() const {
  return {};
}

}  // namespace velum_bench
