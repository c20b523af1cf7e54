// Every picture of the table, in every mode, has the committed hashes; the chosen ones equal their PNGs.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "fingerprint.hpp"
#include "golden_file.hpp"
#include "hash_file.hpp"
#include "scenes.hpp"

using namespace golden;

namespace {

const Places places{VELUM_GOLDEN_PICTURES, VELUM_GOLDEN_FAILURES};

/// What a person needs to see of a picture with other hashes: its committed PNG, or else the first mode's.
void save_failure(const GoldenPicture& picture, const Mode& mode, const velum::Picture& actual) {
  const Mode& first = golden_modes().front();
  const std::string name = picture.name() + "/" + mode.name;
  const auto failure = mode.name == first.name ? failure_of(picture.name(), actual.colour, places)
                                               : failure_of(name, actual.colour, picture.render(first).colour,
                                                            first.name, places);
  MESSAGE(failure.value_or("the colours are as they should be"));
}

void check(const GoldenPicture& picture, const Mode& mode, const std::string& expected) {
  const velum::Picture actual = picture.render(mode);
  const std::string hashes = fingerprint(actual);
  CHECK_MESSAGE(actual.coverage() > 0.0, picture.name());
  if (hashes != expected) {
    save_failure(picture, mode, actual);
    const std::string buffers = differing_buffers(expected, hashes);
    FAIL_CHECK(picture.name() << " by " << mode.name << ": not the committed hashes of " << buffers);
  }
  if (!picture.has_file() || mode.name != golden_modes().front().name) return;
  const auto failure = failure_of(picture.name(), actual.colour, places);
  CHECK_MESSAGE(!failure, *failure);
}

bool cuts_at_a_side(const velum::Counters& counters) {
  return counters.cut_by[2] + counters.cut_by[3] + counters.cut_by[4] + counters.cut_by[5] > 0;
}

int most_pixels_of_a_triangle(const velum::Picture& picture) {
  std::map<std::uint32_t, int> pixels;
  for (int y = 0; y < picture.triangle_id.height(); ++y) {
    for (int x = 0; x < picture.triangle_id.width(); ++x) {
      if (picture.triangle_id.at(x, y) != velum::no_primitive) ++pixels[picture.triangle_id.at(x, y)];
    }
  }
  int most = 0;
  for (const auto& [triangle, count] : pixels) most = std::max(most, count);
  return most;
}

}  // namespace

TEST_CASE("every picture has its committed bytes, in every mode") {
  const auto expected = read_hashes(VELUM_GOLDEN_HASHES);
  const std::vector<GoldenScene> scenes = golden_scenes();
  for (const GoldenPicture& picture : golden_pictures(scenes)) {
    const auto found = expected.find(picture.name());
    if (found == expected.end()) {
      FAIL_CHECK(picture.name() << " has no line in hashes.txt; look at the picture, then ./run goldens");
    }
    const std::string hashes = found == expected.end() ? "" : found->second;
    for (const Mode& mode : golden_modes()) check(picture, mode, hashes);
  }
}

TEST_CASE("every picture has its committed bytes with every instruction set and number of threads") {
  const auto expected = read_hashes(VELUM_GOLDEN_HASHES);
  const std::vector<GoldenScene> scenes = golden_scenes();
  for (const GoldenPicture& picture : golden_pictures(scenes)) {
    const auto found = expected.find(picture.name());
    if (found == expected.end()) continue;  // told above
    const velum::RenderSettings& settings = picture.scene->settings;
    const bool is_large = settings.width * settings.height > 100000;
    for (const Mode& mode : machine_modes()) {
      if (is_large && mode.threads < 7) continue;  // for the time it takes
      check(picture, mode, found->second);
    }
  }
}

TEST_CASE("clipping by all six planes gives one answer, and the guard band's where no side cuts") {
  const std::vector<GoldenScene> scenes = golden_scenes();
  for (const GoldenScene& scene : scenes) {
    if (scene.settings.clip == velum::ClipPolicy::exact) continue;  // told above
    GoldenScene exact = scene;
    exact.settings.clip = velum::ClipPolicy::exact;
    for (const std::string& projection : scene.projections) {
      const GoldenPicture picture{&exact, projection};
      const velum::Picture expected = picture.render(golden_modes().back());
      const std::string hashes = fingerprint(expected);
      if (!cuts_at_a_side(expected.counters)) {
        check(GoldenPicture{&scene, projection}, golden_modes().back(), hashes);
        continue;
      }
      for (const Mode& mode : machine_modes()) check(picture, mode, hashes);
    }
  }
}

TEST_CASE("nothing is committed that no scene gives") {
  std::set<std::string> names;
  std::set<std::string> files;
  const std::vector<GoldenScene> scenes = golden_scenes();
  for (const GoldenPicture& picture : golden_pictures(scenes)) {
    CHECK(names.insert(picture.name()).second);
    if (picture.has_file()) files.insert(file_name(picture.name()).string());
  }
  for (const auto& [name, hashes] : read_hashes(VELUM_GOLDEN_HASHES))
    CHECK_MESSAGE(names.count(name) == 1, name);
  for (const auto& file : std::filesystem::directory_iterator(places.pictures)) {
    const std::string name = file.path().filename().string();
    CHECK_MESSAGE(files.count(name) == 1, name);
  }
}

TEST_CASE("the table holds what it promises, each under every projection") {
  const std::vector<GoldenScene> scenes = golden_scenes();
  for (const std::string name :
       {"letter-f", "solids", "mirrored", "interpenetrating", "ties", "slivers", "sub-pixel", "large", "cut",
        "inside", "not-finite", "transparent", "textured", "lines"}) {
    CAPTURE(name);
    const auto scene =
        std::find_if(scenes.begin(), scenes.end(), [&](const auto& other) { return other.name == name; });
    REQUIRE(scene != scenes.end());
    CHECK(scene->projections.size() == velum::projection_catalogue().size());
  }
}

TEST_CASE("the scenes' extremes are as extreme as their names say") {
  const std::vector<GoldenScene> scenes = golden_scenes();
  for (const GoldenPicture& picture : golden_pictures(scenes)) {
    if (picture.scene->name == "widest" && picture.projection == "front") {
      const velum::Picture rendered = picture.render(golden_modes().front());
      CHECK((rendered.colour.width() == 32768 && rendered.colour.height() == 16));
      CHECK(rendered.bounding_box().width > 16384);
    }
    if (picture.projection != "perspective") continue;
    const velum::Picture rendered = picture.render(golden_modes().front());
    const velum::Counters& counters = rendered.counters;
    if (picture.scene->name == "large") CHECK(most_pixels_of_a_triangle(rendered) >= 10000);
    if (picture.scene->name == "sub-pixel") CHECK(counters.screen_triangles > 2 * counters.fragments);
    if (picture.scene->name == "not-finite") CHECK(counters.not_finite > 0);
    if (picture.scene->name == "cut") CHECK(counters.cut_by[0] > 0);
    if (picture.scene->name == "transparent") CHECK(counters.layers > 3);
  }
}
