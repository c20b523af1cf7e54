// velum matrix, info and projections.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <velum/velum.hpp>

#include "run_program.hpp"

using nlohmann::json;

TEST_CASE("velum matrix shows every stage with its meaning, and the product") {
  const Workplace place;
  const Outcome outcome = place.velum("matrix --eye 0,0,5 --target 0,0,0 --near 1 --far 10 --fov 90");
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "1. T(-COP): "));
  CHECK(contains(outcome.out, "M_rot"));
  CHECK(contains(outcome.out, "Product"));
  CHECK_FALSE(contains(outcome.out, "The way of the point"));
}

TEST_CASE("velum matrix --point follows a point to its pixel") {
  const Workplace place;
  const std::string camera = "matrix --eye 0,0,5 --target 0,0,0 --near 1 --far 10 --fov 90 --size 200x200 ";
  const json report = json::parse(place.velum(camera + "--json --point 2,1,1").out);
  // 4 before the camera, where the window reaches from -4 to 4.
  CHECK(report["point"]["ndc"][0].get<double>() == doctest::Approx(0.5));
  CHECK(report["point"]["ndc"][1].get<double>() == doctest::Approx(0.25));
  CHECK(report["point"]["pixel"][0].get<double>() == doctest::Approx(150.0));
  CHECK(report["point"]["pixel"][1].get<double>() == doctest::Approx(75.0));
  CHECK(report["point"]["outside"].empty());
  CHECK(report["point"]["images"].size() == report["stages"].size() + 1);
  const std::string text = place.velum(camera + "--point 2,1,1").out;
  CHECK(contains(text, "(150.000, 75.000)"));
  CHECK(contains(text, "inside the view volume"));
}

TEST_CASE("--fov is the vertical opening angle in degrees, --hfov the horizontal one") {
  const Workplace place;
  const std::string camera = "matrix --json --eye 0,0,5 --target 0,0,0 --near 1 --far 10 --size 400x200 ";
  const auto ndc = [&](const std::string& angle) {
    return json::parse(place.velum(camera + "--point 2,1,1 " + angle).out)["point"]["ndc"];
  };
  // 4 before the camera; the window reaches from -8 to 8 and from -4 to 4, then from -4 to 4 and from -2
  // to 2.
  CHECK(ndc("--fov 90")[0].get<double>() == doctest::Approx(0.25));
  CHECK(ndc("--fov 90")[1].get<double>() == doctest::Approx(0.25));
  CHECK(ndc("--hfov 90")[0].get<double>() == doctest::Approx(0.5));
  CHECK(ndc("--hfov 90")[1].get<double>() == doctest::Approx(0.5));
}

TEST_CASE("--world-up z turns the named views: the front view has z up and looks along +y") {
  const Workplace place;
  const json turned =
      json::parse(place.velum("matrix --json --projection front --world-up z --point 0.5,0,0.25").out);
  CHECK(turned["camera"]["look"] == json::array({0.0, 1.0, 0.0}));
  CHECK(turned["point"]["ndc"][0].get<double>() > 0.0);
  CHECK(turned["point"]["ndc"][1].get<double>() > 0.0);
}

TEST_CASE("velum matrix says when a point has no picture") {
  const Workplace place;
  const std::string camera = "matrix --eye 0,0,5 --target 0,0,0 --near 1 --far 10 --fov 90 --point 0,0,7 ";
  CHECK(contains(place.velum(camera).out, "not in front of the camera"));
  const json report = json::parse(place.velum(camera + "--json").out);
  CHECK(report["point"]["pixel"].is_null());
  CHECK(contains(report["point"]["outside"].dump(), "in front"));
}

TEST_CASE("velum matrix accepts every projection") {
  const Workplace place;
  for (const velum::ProjectionEntry& entry : velum::projection_catalogue()) {
    const Outcome outcome = place.velum("matrix --json --projection " + std::string(entry.name));
    CAPTURE(entry.name);
    CHECK(outcome.code == 0);
    CHECK(json::parse(outcome.out)["projection"] == std::string(entry.name));
  }
}

TEST_CASE("velum info counts and measures") {
  const Workplace place;
  const json cube = json::parse(place.velum("info builtin:cube --json").out);
  CHECK(cube["triangles"] == 12);
  CHECK(cube["bounds"]["lower"] == json::array({-0.5, -0.5, -0.5}));
  CHECK(cube["bounds"]["upper"] == json::array({0.5, 0.5, 0.5}));
  CHECK(cube["meshes"][0]["closed"] == true);
  CHECK(cube["meshes"][0]["distinct_positions"] == 8);
  const Outcome text = place.velum("info builtin:cube");
  CHECK(text.code == 0);
  CHECK(contains(text.out, "12 triangles"));
  CHECK(contains(text.out, "closed"));
}

TEST_CASE("velum info tells of open edges") {
  const Workplace place;
  place.write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const json info = json::parse(place.velum("info - --json", "triangle.obj").out);
  CHECK(info["meshes"][0]["closed"] == false);
  CHECK(info["meshes"][0]["boundary_edges"] == 3);
  CHECK(contains(place.velum("info triangle.obj").out, "3 edges with a triangle on one side only"));
}

TEST_CASE("velum info tells triangles with a position that is not finite from those without area") {
  const Workplace place;
  place.write("odd.obj",
              "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 0 inf 0\nf 1 2 3\nf 3 2 1\nf 1 4 5\nf 1 1 2\n");
  const json mesh = json::parse(place.velum("info odd.obj --json").out)["meshes"][0];
  CHECK(mesh["triangles_not_finite"] == 1);
  CHECK(mesh["triangles_without_area"] == 1);
  CHECK(mesh["boundary_edges"] == 0);
  CHECK(mesh["closed"] == false);  // what the third triangle would close is not known
  CHECK(
      contains(place.velum("info odd.obj").out, "1 triangle with a position that is not finite: not drawn"));
}

TEST_CASE("velum projections lists the catalogue with parameters and sources") {
  const Workplace place;
  const json list = json::parse(place.velum("projections --json").out);
  REQUIRE(list.size() == velum::projection_catalogue().size());
  const std::string text = place.velum("projections").out;
  for (const json& entry : list) {
    CHECK(contains(text, "  " + entry["name"].get<std::string>() + " "));
    CHECK_FALSE(entry["summary"].get<std::string>().empty());
    CHECK_FALSE(entry["source"].get<std::string>().empty());
  }
  CHECK(contains(text, "angle = 45°"));
}
