#include <doctest/doctest.h>
#include <velum/velum.hpp>
#include "shading/shading.hpp"
#include "visibility/depth_plane.hpp"
TEST_CASE("headers compile") {
  CHECK(velum::outcode({0, 0, 0.5, 1}) == 0);
  static_assert(velum::outcode({0, 2, 0.5, 1}) == 32);
}
