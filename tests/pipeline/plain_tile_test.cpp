#include "pipeline/plain_tile.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cstring>
#include <vector>

#include "image/visibility_buffer.hpp"
#include "random.hpp"
#include "visibility/tile_transfer.hpp"

using namespace velum;

namespace {

constexpr int room = 3;  // pixels beside the tile, which must stay as they are
constexpr int stride = tile_size + room;

struct Planes {
  std::vector<std::uint32_t> colour = std::vector<std::uint32_t>(stride * tile_size, 77u);
  std::vector<float> depth = std::vector<float>(stride * tile_size, -7.0f);
  std::vector<std::uint32_t> ids = std::vector<std::uint32_t>(stride * tile_size, 5u);

  PlainOutput output(bool is_large) {
    return {reinterpret_cast<std::uint8_t*>(colour.data()),
            stride,
            depth.data(),
            stride,
            ids.data(),
            stride,
            {9, 8, 7, 6},
            is_large};
  }
  bool operator==(const Planes&) const = default;
};

/// A tile of runs of ids, in the top left corner of a picture of width × height.
TileBuffer random_tile(Random& random, int width, int height) {
  TileBuffer tile;
  clear_tile({0, 0, width, height}, 0, 0, tile);
  std::uint32_t id = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (random.below(5) == 0) {
        id = random.below(3) == 0 ? no_primitive : static_cast<std::uint32_t>(random.next() >> 32);
      }
      const float r = id == no_primitive ? 0.0f : static_cast<float>(random.uniform());
      tile.primitive[tile_place(x, y)] = static_cast<std::int32_t>(id ^ 0x80000000u);
      tile.depth[tile_place(x, y)] = std::bit_cast<std::int32_t>(r);
    }
  }
  return tile;
}

/// What the tile's pixels give row by row.
std::uint64_t shade_rows(const TileBuffer& tile, int width, int height, const PlainOutput& out) {
  VisibilityBuffer buffer(width, height);
  store_tile(tile, {0, 0, width, height}, 0, 0, buffer);
  return shade_plain_rows_reference({width, height, buffer.primitive.row(0), buffer.primitive.stride(),
                                     buffer.reversed_depth.row(0), buffer.reversed_depth.stride(), out});
}

void check_tile(const TileBuffer& tile, const TileBuffer* pixels, int width, int height) {
  Planes expected;
  const std::uint64_t visible = shade_rows(tile, width, height, expected.output(false));
  for (const Isa isa : available_isas()) {
    for (const bool is_large : {false, true}) {
      CAPTURE(name_of(isa));
      CAPTURE(is_large);
      Planes actual;
      CHECK(plain_tile_kernel(isa)({pixels, width, height, actual.output(is_large)}) == visible);
      CHECK(actual == expected);
    }
  }
}

}  // namespace

TEST_CASE("a tile shaded from its blocks equals the same pixels stored and shaded row by row") {
  Random random{51};
  for (const auto& [width, height] : {std::pair{64, 64}, {64, 3}, {1, 64}, {17, 9}, {63, 40}, {40, 64}}) {
    CAPTURE(width);
    const TileBuffer tile = random_tile(random, width, height);
    check_tile(tile, &tile, width, height);
  }
}

TEST_CASE("a tile where nothing is seen is background at depth 1") {
  TileBuffer tile;
  clear_tile({0, 0, 50, 64}, 0, 0, tile);
  check_tile(tile, nullptr, 50, 64);
}

TEST_CASE("a tile's outputs that nobody wants are left out") {
  Random random{52};
  const TileBuffer tile = random_tile(random, 64, 64);
  for (const Isa isa : available_isas()) {
    Planes planes, only_depth;
    PlainOutput out = planes.output(false);
    const std::uint64_t visible = plain_tile_kernel(isa)({&tile, 64, 64, out});
    out = only_depth.output(false);
    out.colour = nullptr;
    out.ids = nullptr;
    CHECK(plain_tile_kernel(isa)({&tile, 64, 64, out}) == visible);
    CHECK(only_depth.depth == planes.depth);
    CHECK(only_depth.colour == Planes().colour);
    CHECK(only_depth.ids == Planes().ids);
  }
}
