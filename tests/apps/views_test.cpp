// velum views.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <velum/velum.hpp>

#include "run_program.hpp"

using nlohmann::json;

TEST_CASE("velum views draws a sheet of the asked size and reports each view's place and camera") {
  const Workplace place;
  const Outcome outcome = place.velum(
      "views builtin:letter-f -o sheet.png --layout six --angle third --size 800x600 --report sheet.json");
  CHECK(outcome.code == 0);
  const velum::Image<velum::Rgba8> sheet = velum::read_png(place.path("sheet.png"));
  CHECK(sheet.width() == 800);
  CHECK(sheet.height() == 600);
  const json report = json::parse(place.read("sheet.json"));
  CHECK(report["angle"] == "third");
  CHECK(report["views"].size() == 6);
  for (const json& view : report["views"]) {
    CHECK(view["pixels_per_unit"] == report["pixels_per_unit"]);
    CHECK(view["stages"].size() >= 4);
  }
}

TEST_CASE("velum views names its picture after the input and refuses what it cannot use") {
  const Workplace place;
  CHECK(place.velum("views builtin:house --layout four --quiet").code == 0);
  CHECK(place.has("house-views.png"));
  CHECK(place.velum("views builtin:house --layout five").code == 2);
  CHECK(place.velum("views builtin:house --size 40x40").code == 2);
  CHECK(place.velum("views builtin:house -o sheet.jpg").code == 2);
  CHECK(place.velum("views nothere.obj").code == 3);
  CHECK(place.velum("views builtin:house -o nofolder/sheet.png").code == 4);
  CHECK(place.files() == std::vector<std::string>{"house-views.png"});
}

TEST_CASE("velum pyramid draws every level in the picture's size, and a sheet") {
  const Workplace place;
  CHECK(place.velum("pyramid builtin:house -o levels --size 64x48").code == 0);
  for (const char* name : {"levels/level-00.png", "levels/level-03.png", "levels/level-06.png"}) {
    const velum::Image<velum::Rgba8> level = velum::read_png(place.path(name));
    CHECK((level.width() == 64 && level.height() == 48));
  }
  const velum::Image<velum::Rgba8> coarse = velum::read_png(place.path("levels/level-03.png"));
  for (int i = 1; i < 8; ++i) CHECK(coarse.at(24 + i, 24) == coarse.at(24, 24));  // one cell
  CHECK(place.has("levels/sheet.png"));
  CHECK(place.velum("pyramid builtin:house --size 64x48").code == 2);
}

TEST_CASE("velum pyramid tells what the hierarchical method rejects at each level, unless told to be quiet") {
  const Workplace place;
  const std::string said = place.velum("pyramid builtin:torus -o levels --size 64x48").out;
  CHECK(said.find("nodes rejected  polygons rejected") != std::string::npos);
  CHECK(said.find("\n    6          1x1       0 %               0                  0\n") !=
        std::string::npos);
  CHECK(std::count(said.begin(), said.end(), '\n') == 9);  // the folder, the heading, levels 0 ... 6
  CHECK(place.velum("pyramid builtin:torus -o levels --size 64x48 --quiet").out.empty());
}

TEST_CASE("velum render --show octree draws the nodes instead of the picture") {
  const Workplace place;
  CHECK(place.velum("render builtin:sphere --size 160x120 -o picture.png").code == 0);
  CHECK(place.velum("render builtin:sphere --size 160x120 --show octree -o octree.png").code == 0);
  CHECK(place.read("picture.png") != place.read("octree.png"));
  CHECK(place.velum("render builtin:sphere --show nothing").code == 2);
}
