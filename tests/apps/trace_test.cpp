// velum pixel and velum clip-trace.
#include <doctest/doctest.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <velum/velum.hpp>

#include "run_program.hpp"

using nlohmann::json;

namespace {

/// Each image is the stage's matrix times the image before, to the precision of double.
void check_stages(const json& vertex, const json& stages) {
  const json& images = vertex["images"];
  REQUIRE(images.size() == stages.size() + 1);
  for (std::size_t s = 0; s < stages.size(); ++s) {
    for (std::size_t row = 0; row < 4; ++row) {
      double sum = 0.0;
      for (std::size_t column = 0; column < 4; ++column)
        sum += stages[s]["matrix"][row][column].get<double>() * images[s][column].get<double>();
      CHECK(images[s + 1][row].get<double>() == doctest::Approx(sum).epsilon(1e-12));
    }
  }
  for (std::size_t row = 0; row < 4; ++row)
    CHECK(vertex["clip"][row].get<double>() ==
          doctest::Approx(images.back()[row].get<double>()).epsilon(1e-12));
}

/// Edge values by their formula from corners and centre; all three cover.
void check_edges(const json& fragment, const json& centre) {
  for (const json& edge : fragment["edges"]) {
    const auto difference = [](const json& to, const json& from, std::size_t i) {
      return to[i].get<std::int64_t>() - from[i].get<std::int64_t>();
    };
    const json &a = edge["from"], &b = edge["to"];
    const std::int64_t cross =
        difference(b, a, 0) * difference(centre, a, 1) - difference(b, a, 1) * difference(centre, a, 0);
    CHECK(edge["cross"] == cross);
    const std::int64_t dx = difference(b, a, 0), dy = difference(b, a, 1);
    const bool top_left = dy < 0 || (dy == 0 && dx > 0);
    CHECK(edge["value"] == cross - (top_left ? 0 : 1));
    CHECK(edge["value"].get<std::int64_t>() >= 0);
  }
}

}  // namespace

TEST_CASE("velum pixel names the triangle that the picture shows, with numbers that can be followed") {
  const Workplace place;
  for (const std::string projection : {"cabinet", "perspective"}) {
    const std::string common = "builtin:house --size 80x60 --projection " + projection;
    CHECK(place.velum("render " + common + " -o p.png --triangle-ids ids.npy").code == 0);
    const json told = json::parse(place.velum("pixel " + common + " --at 40,30 --json").out);
    REQUIRE(told["fragments"].size() >= 2);
    const json& seen = told["fragments"][0];
    CHECK(seen["outcome"] == "seen");
    CHECK(told["winner"]["triangle"] == seen["triangle"]);
    const json& plane = seen["depth_plane"];
    const double r = plane["r_ref"].get<double>() +
                     plane["dx"].get<double>() * (40 - plane["x_ref"].get<int>()) +
                     plane["dy"].get<double>() * (30 - plane["y_ref"].get<int>());
    CHECK(seen["r"].get<double>() == doctest::Approx(r).epsilon(1e-5));
    CHECK(told["fragments"][1]["r"].get<double>() <= seen["r"].get<double>());
    // The corners of an uncut piece are the vertices' last stage.
    const json& corner = told["winner"]["polygon"][0];
    CHECK(corner["pixel"][0].get<double>() ==
          doctest::Approx(40.0 * (corner["clip"][0].get<double>() / corner["clip"][3].get<double>() + 1.0)));
    for (const json& vertex : told["winner"]["vertices"]) check_stages(vertex, told["stages"]);
    for (const json& fragment : told["fragments"]) check_edges(fragment, told["centre"]);
  }
}

TEST_CASE("velum pixel as text tells who wins and why, and the way through every stage") {
  const Workplace place;
  const Outcome outcome = place.velum("pixel builtin:house --projection cabinet --at 400,300 -o pixel.png");
  CHECK(outcome.code == 0);
  for (const char* part :
       {"The centre is (400 + 1/2, 300 + 1/2)", "E01 = ", "r = (", "wins: r = ", "loses to triangle ",
        "after M_rot^T, camera", "after Sh_oblique", "canonical: / w", "floor(256 x' + 1/2) = ", "outcode",
        "front face", "Depth plane"}) {
    CAPTURE(part);
    CHECK(contains(outcome.out, part));
  }
  const std::string background = place.velum("pixel builtin:house --at 0,0").out;
  CHECK(contains(background, "the background is seen"));
}

TEST_CASE("velum pixel knows segments and points, velum clip-trace only triangles") {
  const Workplace place;
  place.write("lines.obj", "v -1 0 0\nv 1 0 0\nv 0 0 1\nl 1 2\np 3\n");
  const std::string common = " lines.obj --projection front --size 40x40 --line-width 2 --point-size 4 ";
  const json told = json::parse(place.velum("pixel" + common + "--at 20,20 --json").out);
  REQUIRE(told["fragments"].size() == 2);
  CHECK(told["fragments"][0]["kind"] == "point");
  CHECK(told["fragments"][0]["triangle"] == 1);
  CHECK(told["fragments"][1]["kind"] == "segment");
  CHECK(told["fragments"][1]["object_segment"] == 0);
  CHECK(told["winner"].is_null());
  for (const json& fragment : told["fragments"]) check_edges(fragment, told["centre"]);
  const std::string text = place.velum("pixel" + common + "--at 20,20").out;
  CHECK(contains(text, "Point 1 (object 0"));
  CHECK(contains(text, "loses to point 1"));
  const Outcome refused = place.velum("clip-trace lines.obj --triangle 0");
  CHECK(refused.code == 2);
  CHECK(contains(refused.err, "--triangle"));
  CHECK(contains(refused.err, "is a segment or a point"));
}

TEST_CASE("velum clip-trace tells each plane's cuts, and draws them") {
  const Workplace place;
  const std::string view =
      "clip-trace builtin:house --triangle 4 --eye 0.5,0.6,1.2 --target 0,0.4,0 --fov 30 --near 0.3 ";
  const Outcome outcome = place.velum(view + "-o clip.png");
  CHECK(outcome.code == 0);
  for (const char* part : {"Plane 3, right: inside is w - x >= 0", "cuts off: 2",
                           "vertex 3 on the edge from 1 to 2: t = ", "Left is the polygon 0 5 6 3 4"}) {
    CAPTURE(part);
    CHECK(contains(outcome.out, part));
  }
  const json told = json::parse(place.velum(view + "--json").out);
  CHECK(told["verdict"] == "clipped");
  CHECK(told["steps"].size() == 6);
  CHECK(told["result"] == json::array({0, 5, 6, 3, 4}));
  const json& made = told["vertices"][3];
  CHECK(made["t"].get<double>() ==
        doctest::Approx(made["d_in"].get<double>() /
                        (made["d_in"].get<double>() - made["d_out"].get<double>())));
}

TEST_CASE("pixels and triangles that do not exist are mistakes of usage that name the range") {
  const Workplace place;
  const auto expect = [&place](const std::string& arguments, const char* part) {
    const Outcome outcome = place.velum(arguments);
    CAPTURE(arguments);
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, part));
  };
  expect("pixel builtin:house --at 800,0", "x from 0 to 799 and y from 0 to 599");
  expect("pixel builtin:house --at 5", "two whole numbers x,y");
  expect("pixel builtin:house", "--at");
  expect("pixel builtin:house --at 5,5 --radius 65", "0 to 64");
  expect("clip-trace builtin:house --triangle 120", "from 0 to 119");
  expect("clip-trace builtin:house --triangle -1", "whole number");
  expect("clip-trace builtin:house --triangle 1 -o clip.xyz", ".png or .ppm");
  CHECK(place.velum("pixel nothere.obj --at 1,1").code == 3);
}
