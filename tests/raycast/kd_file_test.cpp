#include <doctest/doctest.h>

#include <cstring>
#include <filesystem>

#include "kd_file_trial.hpp"
#include "scene/allocation.hpp"
#include "scene/expect_error.hpp"

using namespace velum;

namespace {

using Bytes = std::vector<std::byte>;

Bytes with_word(Bytes bytes, std::size_t word, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes[4 * word + i] = static_cast<std::byte>(value >> 8 * i);
  return bytes;
}

Bytes mended(Bytes bytes) {
  mend_kd_checksum(bytes);
  return bytes;
}

void expect_refusal(const KdFileTrial& trial, const Bytes& bytes, const std::string& why) {
  expect_error(ErrorKind::read, {"a.kd", why},
               [&] { kd_tree_from_bytes(bytes, trial.triangles(), "a.kd", KdWalk::stack); });
}

/// One to four words or bytes changed, with a taste for small numbers and other words of the file.
Bytes mutated(Bytes bytes, Random& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random.next() % n); };
  for (std::size_t i = 0, n = 1 + below(4); i < n; ++i) {
    const std::size_t words = bytes.size() / 4, word = below(words);
    std::uint32_t other = 0;
    std::memcpy(&other, bytes.data() + 4 * below(words), 4);
    switch (below(4)) {
      case 0:
        bytes = with_word(std::move(bytes), word, other);
        break;
      case 1:
        bytes = with_word(std::move(bytes), word, static_cast<std::uint32_t>(below(200)));
        break;
      default:
        bytes[below(bytes.size())] ^= static_cast<std::byte>(1u << below(8));
        break;
    }
  }
  return bytes;
}

int try_mutations(std::uint64_t seed, int count) {
  const KdFileTrial trial;
  const Bytes sound = trial.sound_file();
  Random random{seed};
  int taken = 0;
  for (int i = 0; i < count; ++i) {
    const Bytes bytes = mutated(sound, random);
    const AllocationWatch watch;
    CHECK_NOTHROW(trial.run(bytes));
    CHECK_NOTHROW(taken += trial.run(mended(bytes)));
    CHECK(watch.peak() < 64 * sound.size());
  }
  return taken;
}

}  // namespace

TEST_CASE("a kd-tree's file gives the same tree again") {
  const KdFileTrial trial;
  const auto path = std::filesystem::temp_directory_path() / "velum_kd_file_test.kd";
  for (const KdWalk walk : {KdWalk::stack, KdWalk::recursive, KdWalk::ropes}) {
    const KdCut cut = walk == KdWalk::stack ? KdCut::referenced : KdCut::split;
    const KdTree built(trial.triangles(), {.walk = walk, .cut = cut});
    save_kd_tree(path, built);
    const auto loaded = load_kd_tree(path, trial.triangles(), walk);
    CHECK(kd_tree_bytes(*loaded) == kd_tree_bytes(built));
    CHECK(loaded->memory() == built.memory());
    Random random{52};
    int hits = 0;
    for (int i = 0; i < 100; ++i) {
      CastCounters before, after;
      const Ray ray = random_ray(random);
      const RayHit expected = built.first_hit(ray, {}, before), found = loaded->first_hit(ray, {}, after);
      CHECK(found.triangle == expected.triangle);
      CHECK(found.t == expected.t);
      CHECK(before.nodes == after.nodes);
      hits += expected.is_hit();
    }
    CHECK(hits > 10);
  }
  std::filesystem::remove(path);
  const KdTree none({});
  CHECK(kd_tree_from_bytes(kd_tree_bytes(none), {}, "")->nodes().empty());
}

TEST_CASE("a kd-tree's file says what is wrong with it") {
  const KdFileTrial trial;
  const Bytes sound = trial.sound_file();
  CHECK(trial.run(sound));
  expect_refusal(trial, {}, "no kd-tree");
  expect_refusal(trial, Bytes(200), "no kd-tree");
  expect_refusal(trial, with_word(sound, 2, 7), "version 7");
  expect_refusal(trial, Bytes(sound.begin(), sound.end() - 1), "bytes where its header announces");
  expect_refusal(trial, with_word(sound, 30, 1), "checksum");
  expect_error(ErrorKind::read, {"other triangles"}, [&] { kd_tree_from_bytes(sound, {}, "a.kd"); });
  RandomTriangles others;
  for (int i = 0; i < 60; ++i) others.add({0, 0, 0}, {1, 0, 0}, {0, 1, static_cast<float>(i)});
  expect_error(ErrorKind::read, {"other triangles"},
               [&] { kd_tree_from_bytes(sound, others.set(), "a.kd"); });
  expect_error(ErrorKind::read, {"nowhere.kd"}, [&] { load_kd_tree("nowhere.kd", trial.triangles()); });
}

TEST_CASE("a kd-tree's file with a right checksum but a wrong tree is refused") {
  const KdFileTrial trial;
  const Bytes sound = trial.sound_file();
  constexpr std::size_t first_node = 20;  // words; each node has two
  REQUIRE_FALSE(KdTree(trial.triangles(), {.walk = KdWalk::ropes, .cut = KdCut::split}).nodes()[0].is_leaf());
  const std::uint32_t root = std::to_integer<std::uint32_t>(sound[4 * first_node]) & 3u;
  const auto refused = [&](std::size_t word, std::uint32_t value, const std::string& why) {
    expect_refusal(trial, mended(with_word(sound, word, value)), why);
  };
  const auto at = [](std::uint32_t node) { return node << 2; };
  refused(first_node, at(0) | root, "right child");  // round in a circle
  refused(first_node, at(1) | root, "right child");
  refused(first_node, at(100000) | root, "right child");
  refused(first_node + 1, 0x7FC00000u, "plane");  // NaN
  refused(first_node + 1, 0x7F800000u, "plane");
  refused(first_node + 1, 0xC3000000u, "plane");  // -128, below the cell
  refused(first_node, 3u, "more ids than there are");
  refused(9, 0xFFF00000u, "pad");    // -infinity
  refused(10, 0x7F800000u, "cell");  // infinity
  refused(sound.size() / 4 - 1, 0xBF800000u, "reach");
  std::uint32_t nodes = 0, ids = 0;
  std::memcpy(&nodes, &sound[12], 4);
  std::memcpy(&ids, &sound[16], 4);
  refused(first_node + 2 * nodes + ids - 1, 60, "no triangle");
  std::vector<std::byte> shorter(sound.begin(), sound.end() - 4);
  refused(16, nodes - 1, "announces");
  expect_refusal(trial, mended(with_word(shorter, 16, nodes - 1)), "one per node");
}

TEST_CASE("a kd-tree's file: every truncation and every single flipped bit is refused") {
  const KdFileTrial trial;
  Bytes bytes = trial.sound_file(KdWalk::stack, KdCut::referenced);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    CHECK_FALSE(trial.run(std::span(bytes).first(length)));
  }
  int taken = 0;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    const auto mask = static_cast<std::byte>(1u << bit % 8);
    bytes[bit / 8] ^= mask;
    taken += trial.run(bytes);
    bytes[bit / 8] ^= mask;
  }
  CHECK(taken == 0);
}

TEST_CASE("a kd-tree's file: no bytes make rays crash or run on for ever, nor take much memory") {
  CHECK(try_mutations(53, 1000) > 30);
}

TEST_CASE("[long] a kd-tree's file: many mutations") {
  try_mutations(54, 30000);
}

TEST_CASE("a kd-tree's file asks for no more memory than it has bytes") {
  const KdFileTrial trial;
  const Bytes sound = trial.sound_file();
  for (const std::size_t word : {3u, 4u}) {
    const AllocationWatch watch;
    expect_refusal(trial, mended(with_word(sound, word, 0xFFFFFFFFu)), "announces");
    CHECK(watch.peak() < 4 * sound.size());
  }
}
