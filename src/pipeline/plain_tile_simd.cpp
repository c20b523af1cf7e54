#include "plain_tile.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/plain_tile_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's header is read anew for every target; it must follow the line above.
#include <hwy/highway.h>

#include "../base/simd_dispatch.hpp"
#include "../shading/plain_pixels-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// A vector of a row's pixels: of one column of blocks or, where it is longer than a block's row, of two.
HWY_INLINE Word load_row(const std::int32_t* row, std::size_t x) {
  const auto* const words_of_row = reinterpret_cast<const std::uint32_t*>(row);
  const std::size_t at = x / block_size * column_room + x % block_size;
#if HWY_TARGET != HWY_SCALAR
  if constexpr (hn::MaxLanes(words) > block_size) {
    const hn::Half<Words> half;
    return hn::Combine(words, hn::Load(half, words_of_row + at + column_room),
                       hn::Load(half, words_of_row + at));
  }
#endif
  return hn::Load(words, words_of_row + at);
}

/// A row of a tile, column of blocks after column.
struct TileRow {
  const std::int32_t* id;
  const std::int32_t* reversed_depth;

  static std::size_t place(std::size_t x) { return x / block_size * column_room + x % block_size; }
  HWY_INLINE Word ids(std::size_t x) const { return hn::Xor(load_row(id, x), hn::Set(words, 0x80000000u)); }
  HWY_INLINE Word reversed_depths(std::size_t x) const { return load_row(reversed_depth, x); }
  HWY_INLINE std::uint32_t id_at(std::size_t x) const {
    return static_cast<std::uint32_t>(id[place(x)]) ^ 0x80000000u;
  }
  HWY_INLINE float reversed_depth_at(std::size_t x) const {
    float r;
    __builtin_memcpy(&r, reversed_depth + place(x), sizeof r);
    return r;
  }
};

struct TileRows {
  const TileBuffer& tile;

  HWY_INLINE TileRow row(std::size_t y) const {
    const int at = tile_place(0, static_cast<int>(y));
    return {tile.primitive + at, tile.depth + at};
  }
};

/// Nothing but background.
struct EmptyRow {
  HWY_INLINE Word ids(std::size_t) const { return hn::Set(words, background_id); }
  HWY_INLINE Word reversed_depths(std::size_t) const { return hn::Zero(words); }
  HWY_INLINE std::uint32_t id_at(std::size_t) const { return background_id; }
  HWY_INLINE float reversed_depth_at(std::size_t) const { return 0.0f; }
};

struct EmptyRows {
  HWY_INLINE EmptyRow row(std::size_t) const { return {}; }
};

}  // namespace

std::uint64_t shade_plain_tile(const PlainTile& tile) {
  const auto width = static_cast<std::size_t>(tile.width), height = static_cast<std::size_t>(tile.height);
  if (tile.pixels == nullptr) return shade_plain(EmptyRows{}, width, height, tile.out);
  return shade_plain(TileRows{*tile.pixels}, width, height, tile.out);
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

ShadePlainTile plain_tile_kernel(Isa isa) {
  static constexpr auto versions = VELUM_KERNEL_VERSIONS(shade_plain_tile);
  return versions.at(isa);
}

}  // namespace velum
#endif
