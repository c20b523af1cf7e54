#include <cstdio>
#include <velum/velum.hpp>

int main() {
  // One corner lies above the canonical volume, the other inside.
  const auto above = velum::outcode({0.0, 2.0, 0.5, 1.0});
  const auto inside = velum::outcode({0.0, 0.0, 0.5, 1.0});
  std::printf("%d %d\n", static_cast<int>(above), static_cast<int>(inside));
  return above == 32 && inside == 0 ? 0 : 1;
}
