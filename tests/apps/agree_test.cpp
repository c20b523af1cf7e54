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

TEST_CASE("velum agree --analytic compares with the equation, at finer and finer tessellations") {
  const Workplace place;
  for (const char* shape : {"builtin:sphere", "builtin:icosphere", "builtin:cylinder"}) {
    CAPTURE(shape);
    const Outcome outcome = place.velum(std::string("agree --analytic --json --size 200x150 ") + shape);
    CHECK(outcome.code == 0);
    const nlohmann::json rows = nlohmann::json::parse(outcome.out)["tessellations"];
    REQUIRE(rows.size() == 3);
    for (const nlohmann::json& row : rows) CHECK(row["unexplained"] == 0);
    CHECK(rows[2]["bound"].get<double>() < rows[0]["bound"].get<double>() / 12.0);
    CHECK(rows[2]["silhouette"].get<int>() < rows[0]["silhouette"].get<int>());
  }
  CHECK(contains(place.velum("agree builtin:sphere --analytic --size 80x60").out, "0 unexplained"));
  CHECK(place.velum("agree builtin:cube --analytic").code == 2);
}
