#include <doctest/doctest.h>

#include <clocale>
#include <glm/geometric.hpp>

#include "base/error.hpp"
#include "projection/projection.hpp"

using namespace velum;
namespace named = velum::projection;

namespace {

void check_same(const Projection& a, const Projection& b) {
  CAPTURE(a.name);
  CHECK(a.name == b.name);
  CHECK(a.family == b.family);
  CHECK(a.look == b.look);
  CHECK(a.up == b.up);
  CHECK(a.to_eye == b.to_eye);
  CHECK(a.shear == b.shear);
  CHECK(a.vertical_angle == b.vertical_angle);
  CHECK(a.vanishing_points == b.vanishing_points);
}

std::string refusal(std::string_view text) {
  try {
    parse_projection(text);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::usage);
    return error.what();
  }
  return "accepted";
}

bool mentions(const std::string& message, const char* part) {
  return message.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("the catalogue has every name of the command line") {
  std::string names;
  for (const ProjectionEntry& entry : projection_catalogue()) {
    names += std::string(entry.name) + " ";
    CHECK_FALSE(entry.summary.empty());
    CHECK_FALSE(entry.source.empty());
    for (const ProjectionEntry::Parameter& parameter : entry.parameters) {
      CHECK_FALSE(parameter.meaning.empty());
      CHECK((parameter.unit == "degrees" || parameter.unit == "ratio"));
    }
  }
  CHECK(names ==
        "front back left right top bottom isometric dimetric dimetric-2to1 trimetric axonometry cavalier "
        "cabinet "
        "natural-oblique military oblique perspective one-point two-point three-point ");
}

TEST_CASE("a name alone means the same as the C++ function's defaults") {
  for (const Projection& p :
       {named::front(), named::back(), named::left(), named::right(), named::top(), named::bottom(),
        named::isometric(), named::dimetric(), named::dimetric_2to1(), named::trimetric(), named::cavalier(),
        named::cabinet(), named::natural_oblique(), named::military(), named::oblique(), named::perspective(),
        named::one_point(), named::two_point(), named::three_point()}) {
    check_same(parse_projection(p.name), p);
  }
  for (const ProjectionEntry& entry : projection_catalogue())
    CHECK(parse_projection(entry.name).name == entry.name);
}

TEST_CASE("parameters are read in degrees, in any order") {
  check_same(parse_projection("trimetric:elevation=20,azimuth=50"),
             named::trimetric(radians(20), radians(50)));
  check_same(parse_projection("trimetric:azimuth=50,elevation=20"),
             named::trimetric(radians(20), radians(50)));
  check_same(parse_projection("oblique:angle=30,scale=0.75"), named::oblique(radians(30), 0.75));
  check_same(parse_projection("cabinet:angle=60"), named::cabinet(radians(60)));
  check_same(parse_projection("military:turn=30,scale=0.5"), named::military(radians(30), 0.5));
  check_same(parse_projection("two-point:fov=55,azimuth=-40"),
             named::two_point(radians(55), radians(20), radians(-40)));
  check_same(parse_projection("axonometry:x=-7,y=90,z=222,sx=1,sy=1,sz=0.5"),
             named::axonometry({radians(-7), radians(90), radians(222)}, {1, 1, 0.5}));
  check_same(parse_projection("trimetric:elevation=-90,azimuth=360"),
             named::trimetric(radians(-90), radians(360)));
}

TEST_CASE("oblique takes alpha instead of scale: scale = cot(alpha)") {
  const auto shear = [](const char* text) { return parse_projection(text).shear; };
  CHECK(glm::length(shear("oblique:alpha=45") - named::cavalier().shear) < 1e-15);
  CHECK(glm::length(shear("oblique:alpha=63.43494882292201") - named::cabinet().shear) < 1e-15);
  CHECK(glm::length(shear("oblique:alpha=90")) < 1e-15);
  CHECK(mentions(refusal("oblique:alpha=45,scale=1"), "alpha"));
  CHECK(mentions(refusal("oblique:alpha=0"), "alpha"));
  CHECK(mentions(refusal("oblique:alpha=91"), "alpha"));
}

TEST_CASE("what is not understood is named, with what would be") {
  CHECK(mentions(refusal("cabinet:scale=x"), "cabinet:scale"));
  CHECK(mentions(refusal("cabinet:scale=x"), "\"x\" is not a number"));
  CHECK(mentions(refusal("cabinet:size=1"), "\"size\""));
  CHECK(mentions(refusal("cabinet:size=1"), "angle, scale"));
  CHECK(mentions(refusal("isometric:angle=30"), "no parameters"));
  CHECK(mentions(refusal("cabinett"), "three-point"));
  CHECK(mentions(refusal(""), "isometric"));
  for (const char* bad : {"cabinet:",
                          "cabinet:scale",
                          "cabinet:scale=",
                          "cabinet:scale=1,",
                          "cabinet:,scale=1",
                          "cabinet:scale=1,scale=1",
                          "cabinet:scale=nan",
                          "cabinet:scale=inf",
                          "cabinet:scale=1e999",
                          "cabinet:scale=0.5x",
                          "cabinet:scale=0,5",
                          "cabinet:scale= 1",
                          "cabinet:=1",
                          "Cabinet",
                          " cabinet",
                          "cabinet:scale=-1",
                          "perspective:fov=180",
                          "trimetric:elevation=100",
                          "isometric:",
                          "axonometry:x=0,y=0,z=0",
                          "cabinet:scale==1"}) {
    CAPTURE(bad);
    CHECK(refusal(bad) != "accepted");
  }
}

TEST_CASE("views that no standard defines say that they are derived") {
  for (const ProjectionEntry& entry : projection_catalogue()) {
    const bool is_derived = entry.name == "dimetric" || entry.name == "dimetric-2to1";
    CHECK((entry.source.find("derived") == 0) == is_derived);
  }
}

TEST_CASE("numbers are read alike in a locale with a decimal comma") {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8"}) {
    if (std::setlocale(LC_ALL, locale) != nullptr) break;
  }
  check_same(parse_projection("oblique:angle=22.5,scale=0.75"), named::oblique(radians(22.5), 0.75));
  std::setlocale(LC_ALL, before.c_str());
}
