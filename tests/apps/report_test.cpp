#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <velum/velum.hpp>

#include "run_program.hpp"

namespace {

using nlohmann::json;

json report_of(const std::string& options) {
  const Workplace place;
  const Outcome outcome = place.velum("render " + options + " --report r.json --quiet");
  REQUIRE(outcome.code <= 1);
  return json::parse(place.read("r.json"));
}

/// The product of the stages in the order of application, applied to a point.
std::vector<double> through(const json& stages, std::vector<double> point) {
  for (const json& stage : stages) {
    std::vector<double> image;
    for (const json& row : stage["matrix"]) {
      double sum = 0.0;
      for (std::size_t i = 0; i < 4; ++i) sum += row[i].get<double>() * point[i];
      image.push_back(sum);
    }
    point = image;
  }
  return point;
}

}  // namespace

TEST_CASE("the report has size, coverage, bounding box, counters, stages and hashes") {
  const json report = report_of("builtin:cube --size 64x48 --projection front");
  CHECK(report["size"] == json::array({64, 48}));
  // A square that fills the height but for the margin of 1/20 at each side: 43 of 48 pixels, 0.4 in the
  // middle.
  const json box = report["bbox"];
  const int width = box[2].get<int>() - box[0].get<int>();
  const int height = box[3].get<int>() - box[1].get<int>();
  CHECK(width == height);
  CHECK(report["coverage"].get<double>() == doctest::Approx(width * height / (64.0 * 48.0)));
  CHECK(report["counters"]["triangles"] == 12);
  CHECK(report["counters"]["instances"] == 1);
  CHECK(report["counters"]["outside"]["behind"] == 0);
  CHECK(report["counters"]["pixels_shaded"] == width * height);
  for (const std::string name : {"colour", "depth", "object_id", "triangle_id"}) {
    CHECK(report["sha256"][name].get<std::string>().size() == 64);
  }
}

TEST_CASE(
    "the stages of the report have names, meanings and matrices by rows, and lead into the view volume") {
  const json report = report_of("builtin:cube --size 64x48 --eye 0,0,5 --target 0,0,0 --near 1 --far 9");
  REQUIRE(report["stages"].size() >= 3);
  for (const json& stage : report["stages"]) {
    CHECK_FALSE(stage["name"].get<std::string>().empty());
    CHECK_FALSE(stage["meaning"].get<std::string>().empty());
    CHECK(stage["matrix"].size() == 4);
    for (const json& row : stage["matrix"]) CHECK(row.size() == 4);
  }
  const std::vector<double> near = through(report["stages"], {0, 0, 4, 1});
  const std::vector<double> far = through(report["stages"], {0, 0, -4, 1});
  CHECK(near[2] / near[3] == doctest::Approx(0.0));
  CHECK(far[2] / far[3] == doctest::Approx(1.0));
}

TEST_CASE("the bounding box is half-open and stands at the crop's own corner") {
  const json whole = report_of("builtin:cube --size 64x48 --projection front");
  const int left = whole["bbox"][0].get<int>();
  const int top = whole["bbox"][1].get<int>();
  const json crop = report_of("builtin:cube --size 64x48 --projection front --crop " + std::to_string(left) +
                              "," + std::to_string(top) + ",3,2");
  CHECK(crop["size"] == json::array({3, 2}));
  CHECK(crop["bbox"] == json::array({0, 0, 3, 2}));
  CHECK(crop["coverage"] == 1.0);
}

TEST_CASE("a blank picture has a report, too") {
  const json report = report_of("builtin:cube --size 40x30 --eye 0,0,5 --target 0,0,10 --near 1 --far 9");
  CHECK(report["coverage"] == 0.0);
  CHECK(report["bbox"] == json::array({0, 0, 0, 0}));
  CHECK(report["counters"]["outside"]["in front"] == 12);
  // 1200 times 0xFFFFFFFF, and 1200 times 1.0f, little-endian.
  CHECK(report["sha256"]["object_id"] == report["sha256"]["triangle_id"]);
  CHECK(report["sha256"]["object_id"] == "09e99f4973f0e70d5214b6f40ca74070fbfc18627880ff90803b4174e36d3b96");
  CHECK(report["sha256"]["depth"] == "f623803cfb105f32590fe3c5ea288c935a62a219f18b4ce64c2fcdf8ca2cfd39");
}

TEST_CASE("the report goes to standard output as -") {
  const Workplace place;
  const Outcome outcome = place.velum("render builtin:cube --size 32x24 -o c.png --report -");
  CHECK(outcome.code == 0);
  CHECK(json::parse(outcome.out)["size"] == json::array({32, 24}));
  CHECK(contains(outcome.err, "c.png: 32x24"));
}

TEST_CASE("scanline and z-buffer write the same report, byte for byte") {
  const Workplace place;
  for (const std::string projection : {"cabinet", "isometric", "perspective"}) {
    const std::string render = "render builtin:house --size 64x48 --projection " + projection;
    CHECK(place.velum(render + " --visibility scanline --report scanline.json").code == 0);
    CHECK(place.velum(render + " --visibility zbuffer --report zbuffer.json").code == 0);
    CHECK(place.read("scanline.json") == place.read("zbuffer.json"));
  }
}

TEST_CASE("the method's own work is reported on demand") {
  const std::string options = "builtin:house --size 64x48 --report-work --visibility ";
  const json scanline = report_of(options + "scanline");
  const json zbuffer = report_of(options + "zbuffer --isa reference");
  CHECK(scanline["work"]["spans"].get<int>() > 0);
  CHECK(zbuffer["work"]["spans"] == 0);
  CHECK(zbuffer["work"]["pixels_tested"] > scanline["work"]["pixels_tested"]);
  CHECK(zbuffer["work"]["fragments"] == scanline["work"]["fragments"]);
  CHECK(report_of(options + "zbuffer")["work"]["drawn_blocks"].get<int>() > 0);
  CHECK_FALSE(report_of("builtin:house --size 64x48").contains("work"));
  CHECK(Workplace().velum("render builtin:house --report-work").code == 2);
}

TEST_CASE("what the hierarchical method left out, and at which level, is reported with its work") {
  const std::string options = "builtin:sphere --size 64x48 --report-work --visibility ";
  const json whole = report_of(options + "zbuffer");
  const json part = report_of(options + "hierarchical --crop 20,20,3,3");
  const json& work = part["work"]["hierarchy"];
  CHECK(work["nodes_outside"].get<int>() > 0);
  CHECK(work["nodes_hidden_at"].is_array());
  CHECK(work["octree_bytes"].get<int>() > 1000);
  CHECK(part["counters"]["triangles"].get<int>() + work["triangles_left_out"].get<int>() ==
        whole["counters"]["triangles"].get<int>());
  CHECK(report_of(options + "hierarchical")["sha256"] == whole["sha256"]);
  const json polygons = report_of(options + "hierarchical --hierarchical polygons");
  CHECK(polygons["sha256"] == whole["sha256"]);
  CHECK(polygons["work"]["hierarchy"]["polygons_tested"].get<int>() > 0);
  const Outcome blank =
      Workplace().velum("render builtin:cube --eye 0,0,5 --target 0,0,10 --visibility hierarchical");
  CHECK(blank.code == 1);
  CHECK(contains(blank.err, "behind the camera"));
}

TEST_CASE("the report tells the depth resolution at the far end, by the format") {
  const std::string camera = "builtin:cube --size 32x32 --projection front --near 1 --far 11 --depth-format ";
  CHECK(report_of(camera + "8")["depth_resolution_at_far"].get<double>() == doctest::Approx(10.0 / 255));
  CHECK(report_of(camera + "16")["depth_resolution_at_far"].get<double>() == doctest::Approx(10.0 / 65535));
  CHECK(report_of(camera + "float")["depth_resolution_at_far"].get<double>() < 1e-6);
}

TEST_CASE("depth interpolation with the z-buffer is a usage error; with scanline it renders") {
  const Workplace place;
  CHECK(place.velum("render builtin:cube --size 8x8 --z-interpolation edges").code == 2);
  CHECK(place.velum("render builtin:cube --size 8x8 --depth-format 12").code == 2);
  CHECK(place.velum("render builtin:cube --size 8x8 --visibility scanline --z-interpolation edges").code ==
        0);
}
