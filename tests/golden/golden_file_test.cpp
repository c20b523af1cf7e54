// The kit itself: what must fail fails, says where, and leaves the three pictures; a refresh touches only
// what differs.
#include "golden_file.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <fstream>
#include <string>

#include "hash_file.hpp"

using namespace golden;
using velum::Image;
using velum::Rgba8;
namespace fs = std::filesystem;

namespace {

/// An empty folder of its own, removed at the end.
struct Workplace {
  fs::path folder;
  Places places;

  explicit Workplace(const std::string& name)
      : folder(fs::path(VELUM_GOLDEN_FAILURES) / ("kit-" + name)),
        places{folder / "pictures", folder / "failures"} {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  ~Workplace() { fs::remove_all(folder); }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
};

Image<Rgba8> picture() {
  Image<Rgba8> image(9, 7);
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 9; ++x) {
      image.at(x, y) = {static_cast<std::uint8_t>(20 * x), static_cast<std::uint8_t>(30 * y), 90, 200};
    }
  }
  return image;
}

bool contains(const std::optional<std::string>& text, const std::string& part) {
  return text && text->find(part) != std::string::npos;
}

/// Long ago, so that a write shows.
fs::file_time_type age(const fs::path& path) {
  fs::last_write_time(path, fs::last_write_time(path) - std::chrono::hours(24));
  return fs::last_write_time(path);
}

}  // namespace

TEST_CASE("a missing golden fails and the actual picture is saved") {
  const Workplace work("missing");
  const auto failure = failure_of("scene/front", picture(), work.places);
  CHECK(contains(failure, "there is no golden"));
  CHECK(contains(failure, "./run goldens"));
  CHECK(compare(velum::read_png(work.places.failures / "scene.front.actual.png"), picture()).same_bytes);
  CHECK_FALSE(fs::exists(work.places.pictures / "scene.front.png"));
}

TEST_CASE("an equal golden passes and leaves nothing") {
  const Workplace work("equal");
  CHECK(refresh("scene/front", picture(), work.places));
  CHECK_FALSE(failure_of("scene/front", picture(), work.places));
  CHECK_FALSE(fs::exists(work.places.failures));
}

TEST_CASE("one changed pixel is found, and seen in the heat map") {
  const Workplace work("planted");
  refresh("scene/front", picture(), work.places);
  Image<Rgba8> changed = picture();
  changed.at(5, 3).g = static_cast<std::uint8_t>(changed.at(5, 3).g + 1);
  const auto failure = failure_of("scene/front", changed, work.places);
  CHECK(contains(failure, "1 pixel differs, the worst at (5, 3) by 1"));
  const fs::path& folder = work.places.failures;
  for (const std::string what : {"actual", "expected", "heat"}) {
    CHECK(contains(failure, (folder / ("scene.front." + what + ".png")).string()));
  }
  CHECK(compare(velum::read_png(folder / "scene.front.actual.png"), changed).same_bytes);
  CHECK(compare(velum::read_png(folder / "scene.front.expected.png"), picture()).same_bytes);
  const Image<Rgba8> heat = velum::read_png(folder / "scene.front.heat.png");
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 9; ++x) CHECK((heat.at(x, y).r > 100) == (x == 5 && y == 3));
  }
}

TEST_CASE("another alpha, or another size, is a difference") {
  const Workplace work("size");
  refresh("scene/front", picture(), work.places);
  Image<Rgba8> changed = picture();
  changed.at(0, 6).a = 255;
  CHECK(contains(failure_of("scene/front", changed, work.places), "the worst at (0, 6) by 55"));
  CHECK(contains(failure_of("scene/front", Image<Rgba8>(8, 7), work.places), "8x7 instead of 9x7"));
}

TEST_CASE("a refresh writes what differs and nothing else") {
  const Workplace work("refresh");
  CHECK(refresh("a", picture(), work.places));
  CHECK(refresh("b", picture(), work.places));
  const auto a_before = age(work.places.pictures / "a.png");
  const auto b_before = age(work.places.pictures / "b.png");
  Image<Rgba8> changed = picture();
  changed.at(8, 0).b = 0;
  CHECK_FALSE(refresh("a", picture(), work.places));
  CHECK(refresh("b", changed, work.places));
  CHECK(fs::last_write_time(work.places.pictures / "a.png") == a_before);
  CHECK(fs::last_write_time(work.places.pictures / "b.png") > b_before);
  CHECK_FALSE(failure_of("b", changed, work.places));
}

TEST_CASE("the text file is written only where its content differs") {
  const Workplace work("text");
  const fs::path path = work.folder / "hashes.txt";
  CHECK(refresh_text(path, "a/front colour=1 depth=2\n"));
  const auto before = age(path);
  CHECK_FALSE(refresh_text(path, "a/front colour=1 depth=2\n"));
  CHECK(fs::last_write_time(path) == before);
  CHECK(refresh_text(path, "a/front colour=1 depth=3\n"));
  CHECK(fs::last_write_time(path) > before);
  CHECK(read_hashes(path).at("a/front") == "colour=1 depth=3");
}

TEST_CASE("hash lines: a missing file and a broken line are errors, and the differing buffers are named") {
  const Workplace work("hashes");
  CHECK_THROWS_AS(read_hashes(work.folder / "none.txt"), velum::Error);
  refresh_text(work.folder / "broken.txt", "nothing\n");
  CHECK_THROWS_AS(read_hashes(work.folder / "broken.txt"), velum::Error);
  CHECK(differing_buffers("colour=1 depth=2 objects=3", "colour=1 depth=9 objects=4") == "depth, objects");
  CHECK(differing_buffers("", "colour=1 depth=9") == "colour, depth");
}
