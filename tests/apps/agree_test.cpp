// velum agree: the raster against ray casting.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "run_program.hpp"

TEST_CASE("velum agree explains every difference and draws a map") {
  const Workplace place;
  const Outcome outcome = place.velum("agree builtin:torus --size 64x48 -o map.png");
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "unexplained"));
  CHECK(place.has("map.png"));
}

TEST_CASE("velum agree --json counts the classes, the same with every accelerator") {
  const Workplace place;
  nlohmann::json first;
  for (const char* name : {"bvh", "kdtree", "grid", "nested-grid", "octree", "bsp", "brute-force"}) {
    CAPTURE(name);
    const Outcome outcome = place.velum(
        "agree builtin:torus --projection cabinet --size 64x48 --json --accelerator " + std::string(name));
    REQUIRE(outcome.code == 0);
    nlohmann::json found = nlohmann::json::parse(outcome.out);
    CHECK(found["accelerator"] == name);
    CHECK(found["pixels"] == 64 * 48);
    CHECK(found["classes"]["unexplained"] == 0);
    found.erase("accelerator");
    if (first.is_null()) first = found;
    CHECK(found == first);
  }
}

TEST_CASE("velum agree refuses an accelerator that there is not") {
  const Workplace place;
  CHECK(place.velum("agree builtin:torus --accelerator magic").code == 2);
  CHECK(place.velum("render builtin:torus --visibility raycast --depth-format 16").code == 2);
}
