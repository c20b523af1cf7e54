// velum ray: what a ray meets, the boxes on its way, and their picture.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "run_program.hpp"

using nlohmann::json;

namespace {

const std::string torus = "ray builtin:torus --size 80x60 --pixel 40,40 ";

}  // namespace

TEST_CASE("velum ray names the hits, nearest first") {
  const Workplace place;
  const Outcome outcome = place.velum(torus);
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "The ray through pixel 40,40"));
  CHECK(contains(outcome.out, "It meets, nearest first:"));
  CHECK_FALSE(contains(outcome.out, "The way through the boxes"));
  CHECK(contains(place.velum("ray builtin:torus --size 80x60 --pixel 0,0").out, "It meets nothing."));
}

TEST_CASE("velum ray --traversal gives each step a number and a reason") {
  const Workplace place;
  const std::string text = place.velum(torus + "--traversal").out;
  CHECK(contains(text, "    0  leaf 0 "));
  CHECK(contains(text, ": entered, t "));
  CHECK(contains(text, " before it enters "));
  CHECK(contains(text, "hit, the nearest so far, t = "));
  CHECK(contains(text, "left out: entered after the nearest hit"));
}

TEST_CASE("velum ray --traversal says which tree its steps are of") {
  const Workplace place;
  CHECK(contains(place.velum(torus + "--traversal --accelerator grid").out,
                 "of the binary hierarchy (binary-bvh; the counts above are of grid):"));
  const std::string own = place.velum(torus + "--traversal --accelerator binary-bvh").out;
  CHECK(contains(own, "of the binary hierarchy (binary-bvh):"));
  const json told = json::parse(place.velum(torus + "--traversal --json --accelerator grid").out);
  CHECK(told["accelerator"] == "grid");
  CHECK(told["traversal_of"] == "binary-bvh");
}

TEST_CASE("velum ray --json tells the same, and why a box is missed can be checked") {
  const Workplace place;
  const json told = json::parse(place.velum(torus + "--traversal --json").out);
  REQUIRE(told["hits"].size() >= 2);
  CHECK(told["hits"][0]["t"].get<double>() <= told["hits"][1]["t"].get<double>());
  const json& steps = told["traversal"];
  json nearest;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    CHECK(steps[i]["step"] == i);
    if (steps[i]["outcome"] == "hit, the nearest so far") nearest = steps[i];
    if (steps[i]["kind"] == "triangle" || !contains(steps[i]["outcome"].get<std::string>(), "missed"))
      continue;
    CHECK(steps[i]["leaves"].get<double>() < steps[i]["enters"].get<double>());
  }
  CHECK(nearest["index"] == told["hits"][0]["primitive"]);
  CHECK(nearest["t"][0] == told["hits"][0]["t"]);
}

TEST_CASE("velum ray --depth leaves the deeper steps out and counts them") {
  const Workplace place;
  const json all = json::parse(place.velum(torus + "--traversal --json").out)["traversal"];
  const json few = json::parse(place.velum(torus + "--traversal --json --depth 3").out)["traversal"];
  CHECK(few.size() < all.size());
  for (const json& step : few) CHECK(step["level"].get<int>() <= 3);
  CHECK(contains(place.velum(torus + "--traversal --depth 3").out, "deeper step"));
  CHECK(place.velum(torus + "--depth x").code == 2);
}

TEST_CASE("velum ray -o draws the boxes; less deep, fewer panels") {
  const Workplace place;
  CHECK(place.velum(torus + "-o boxes.png").code == 0);
  CHECK(place.velum(torus + "-o few.png --depth 3").code == 0);
  CHECK(place.has("boxes.png"));
  CHECK(place.read("few.png").size() < place.read("boxes.png").size());
  CHECK(place.velum(torus + "-o boxes.xyz").code == 2);
  CHECK(place.velum(torus + "-o nowhere/boxes.png").code == 4);
}
