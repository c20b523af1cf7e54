// velum diff and its four exit codes: 0 within the limits, 1 outside, 2 usage, 3 unreadable or of different
// size.
#include <doctest/doctest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <velum/velum.hpp>

#include "run_program.hpp"

using namespace velum;

namespace {

/// a.png, and b.png, in which one pixel is lighter by 12 and another by 1; with floats in a.pfm and b.pfm.
struct Pictures : Workplace {
  Pictures() {
    Image<Rgba8> a(8, 6, Rgba8{100, 110, 120, 255});
    write_png(path("a.png"), a);
    a.at(5, 2).g = 122;
    a.at(1, 4).r = 101;
    write_png(path("b.png"), a);
    write_ppm(path("b.ppm"), a);
    write_png(path("small.png"), Image<Rgba8>(8, 5));
    Image<float> depth(4, 3, 0.5f);
    write_pfm(path("a.pfm"), depth);
    depth.at(3, 1) = 0.625f;
    write_pfm(path("b.pfm"), depth);
    depth.at(0, 0) = std::numeric_limits<float>::infinity();
    write_pfm(path("c.pfm"), depth);
    write_pfm(path("rgb.pfm"), Image<glm::vec3>(4, 3));
    write("noise.png", "no picture");
  }
};

}  // namespace

TEST_CASE("equal pictures end with 0") {
  const Pictures place;
  const Outcome outcome = place.velum("diff a.png a.png");
  CHECK(outcome.code == 0);
  CHECK(outcome.out == "a.png and a.png: 8x6, equal to the byte\n");
  CHECK(place.velum("diff b.png b.ppm").code == 0);
  CHECK(place.velum("diff a.pfm a.pfm").code == 0);
}

TEST_CASE("different pictures end with 1 and are measured") {
  const Pictures place;
  const Outcome outcome = place.velum("diff a.png b.png");
  CHECK(outcome.code == 1);
  CHECK(contains(outcome.out, "8x6, 2 pixels with a difference over 0, outside the limits"));
  CHECK(contains(outcome.out, "largest difference 12, first at (5, 2)"));
  CHECK(contains(outcome.out, "PSNR"));
  CHECK(outcome.err.empty());
}

TEST_CASE("the limits let pass what is within") {
  const Pictures place;
  CHECK(place.velum("diff a.png b.png --max-diff 11").code == 1);
  CHECK(place.velum("diff a.png b.png --max-diff 12").code == 0);
  CHECK(place.velum("diff a.png b.png --max-pixels 1").code == 1);
  CHECK(place.velum("diff a.png b.png --max-pixels 2").code == 0);
  CHECK(place.velum("diff a.png b.png --max-diff 1 --max-pixels 1").code == 0);
  CHECK(place.velum("diff a.pfm b.pfm --max-diff 0.124").code == 1);
  CHECK(place.velum("diff a.pfm b.pfm --max-diff 0.125").code == 0);
  CHECK(place.velum("diff a.pfm c.pfm --max-diff 1e300").code == 1);
}

TEST_CASE("--json says the same in numbers") {
  const Pictures place;
  const Outcome outcome = place.velum("diff a.png b.png --json --max-diff 1");
  CHECK(outcome.code == 1);
  const auto json = nlohmann::json::parse(outcome.out);
  CHECK(json["same_bytes"] == false);
  CHECK(json["max"] == 12.0);
  CHECK(json["mean"] == doctest::Approx(13.0 / (8 * 6 * 4)));
  CHECK(json["pixels_over"] == 1);
  CHECK(json["worst"] == nlohmann::json{5, 2});
  CHECK(json["within_limits"] == false);
  const auto equal = nlohmann::json::parse(place.velum("diff a.png a.png --json").out);
  CHECK(equal["same_bytes"] == true);
  CHECK(equal["psnr"].is_null());
  CHECK(equal["worst"].is_null());
  CHECK(equal["within_limits"] == true);
}

TEST_CASE("the heat map glows where the pictures differ") {
  const Pictures place;
  CHECK(place.velum("diff a.png b.png -o heat.png").code == 1);
  const Image<Rgba8> heat = read_png(place.path("heat.png"));
  REQUIRE(heat.width() == 8);
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) {
      const bool differs = (x == 5 && y == 2) || (x == 1 && y == 4);
      CHECK((heat.at(x, y).r > 100) == differs);
    }
  }
}

TEST_CASE("diff: mistakes of usage end with 2") {
  const Pictures place;
  CHECK(place.velum("diff a.png").code == 2);
  CHECK(place.velum("diff - -").code == 2);
  CHECK(place.velum("diff a.png b.png --max-diff x").code == 2);
  CHECK(place.velum("diff a.png b.png --max-diff -1").code == 2);
  CHECK(place.velum("diff a.png b.png --max-pixels -1").code == 2);
  CHECK(place.velum("diff a.png b.png -o heat.gif").code == 2);
  CHECK(place.velum("diff a.png b.png --wat").code == 2);
}

TEST_CASE("diff: what cannot be read, or differs in size or kind, ends with 3 and says so") {
  const Pictures place;
  const auto refused = [&place](const std::string& arguments, const std::string& text) {
    const Outcome outcome = place.velum("diff " + arguments);
    CAPTURE(outcome.err);
    CHECK(outcome.code == 3);
    CHECK(contains(outcome.err, text));
    CHECK(outcome.out.empty());
  };
  refused("a.png nothere.png", "nothere.png");
  refused("noise.png a.png", "noise.png");
  refused("a.png small.png", "differ in size: 8x6 and 8x5");
  refused("a.png a.pfm", "8-bit colours");
  refused("a.pfm rgb.pfm", "three floats");
}
