#include "plain_rows.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/plain_rows_simd.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's header is read anew for every target; it must follow the line above.
#include <hwy/highway.h>

#include "../base/simd_dispatch.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Words = hn::ScalableTag<std::uint32_t>;
using Floats = hn::Repartition<float, Words>;
using Word = hn::Vec<Words>;
constexpr Words words;
constexpr Floats floats;
constexpr std::uint32_t background_id = 0xFFFFFFFFu;  // no_primitive

/// a · b >> 16. @pre a, b < 2^16
HWY_INLINE Word fraction_of(Word a, Word b) {
  return hn::ShiftRight<16>(hn::Mul(a, b));
}

/// 16-bit fraction → 0 … 255, half up.
HWY_INLINE Word code_of(Word fraction) {
  const Word times_255 = hn::Sub(hn::ShiftLeft<8>(fraction), fraction);
  return hn::ShiftRight<16>(hn::Add(times_255, hn::Set(words, 0x8000u)));
}

/// How many bytes up the code of the brightest (the middle) channel stands in a colour, two bits for each of
/// the six sectors of hue, 0 first; the darkest has the third place.
constexpr std::uint32_t place_of_highest = 0b00'10'10'01'01'00;
constexpr std::uint32_t place_of_middle = 0b10'00'01'10'00'01;

/// In bits.
HWY_INLINE Word shift_for(std::uint32_t places, Word sector) {
  const Word place = hn::Shr(hn::Set(words, places), hn::ShiftLeft<1>(sector));
  return hn::ShiftLeft<3>(hn::And(place, hn::Set(words, 3u)));
}

/// id_colour() in sRGB codes, operation for operation; red in the lowest byte.
HWY_INLINE Word colours_of(Word id) {
  const Word all = hn::Set(words, 0xFFFFu);
  const auto hash = [&](std::uint32_t factor) {
    return hn::ShiftRight<16>(hn::Mul(id, hn::Set(words, factor)));
  };
  const Word hue = hash(0x9E3779B9u);
  const Word saturation = hn::Sub(all, fraction_of(hash(0xC13FA9A9u), hn::Set(words, 0x9000u)));
  const Word value = hn::Sub(all, fraction_of(hash(0x6A09E667u), hn::Set(words, 0x8000u)));

  const Word six_hues = hn::Add(hn::ShiftLeft<2>(hue), hn::ShiftLeft<1>(hue));
  const Word sector = hn::ShiftRight<16>(six_hues);
  const Word is_even = hn::Sub(hn::And(sector, hn::Set(words, 1u)), hn::Set(words, 1u));
  const Word part = hn::And(hn::Xor(six_hues, is_even), all);  // the fraction, in even sectors 1 - fraction
  const auto channel = [&](Word kept) { return code_of(fraction_of(value, kept)); };
  const Word highest = channel(all);
  const Word middle = channel(hn::Sub(all, fraction_of(saturation, part)));
  const Word lowest = channel(hn::Sub(all, fraction_of(saturation, all)));

  const Word high_shift = shift_for(place_of_highest, sector);
  const Word middle_shift = shift_for(place_of_middle, sector);
  const Word low_shift = hn::Sub(hn::Set(words, 24u), hn::Add(high_shift, middle_shift));
  const Word coloured = hn::Or(hn::Shl(highest, high_shift), hn::Shl(middle, middle_shift));
  return hn::Or(hn::Or(coloured, hn::Shl(lowest, low_shift)), hn::Set(words, 0xFF000000u));
}

/// The colours of one vector of pixels after the other; neighbours mostly show the same.
struct Colours {
  explicit Colours(const std::uint8_t* background_rgba) {
    std::uint32_t packed;
    __builtin_memcpy(&packed, background_rgba, sizeof packed);
    background = hn::Set(words, packed);
    colours = background;
  }

  /// @param last  the id in the last lane
  HWY_INLINE Word of(Word id, std::uint32_t last) {
    if (hn::AllTrue(words, hn::Eq(id, last_id))) {
      const auto last_lane = hn::IndicesFromVec(words, hn::Set(words, hn::MaxLanes(words) - 1));
      colours = hn::TableLookupLanes(colours, last_lane);
    } else {
      const auto is_hidden = hn::Eq(id, hn::Set(words, background_id));
      colours = hn::IfThenElse(is_hidden, background, colours_of(id));
      last_id = hn::Set(words, last);
    }
    return colours;
  }

  Word background;
  Word last_id = hn::Set(words, background_id);  ///< in the last lane of the vector before
  Word colours;                                  ///< of that vector
};

/// Stores past the caches: large pictures would only push out what is still to be read.
struct Streaming {
  HWY_INLINE void operator()(Word v, std::uint32_t* out) const { hn::Stream(v, words, out); }
};
/// The pixels need not be aligned.
struct Storing {
  HWY_INLINE void operator()(Word v, std::uint32_t* out) const { hn::StoreU(v, words, out); }
};

/// Pixels of one row, a whole number of vectors. @return how many are hidden
template <typename Store>
HWY_INLINE std::size_t shade_colours(const std::uint32_t* ids, std::size_t width, Colours& colours,
                                     std::uint8_t* out, const Store& store) {
  const std::size_t lanes = hn::Lanes(words);
  const Word nothing = hn::Set(words, background_id);
  std::size_t hidden = 0;
  for (std::size_t x = 0; x < width; x += lanes) {
    const Word id = hn::LoadU(words, ids + x);
    hidden += hn::CountTrue(words, hn::Eq(id, nothing));
    if (out != nullptr)
      store(colours.of(id, ids[x + lanes - 1]), reinterpret_cast<std::uint32_t*>(out + 4 * x));
  }
  return hidden;
}

template <typename Store>
HWY_INLINE void write_depths(const float* reversed_depth, std::size_t width, float* out, const Store& store) {
  const auto one = hn::Set(floats, 1.0f);
  for (std::size_t x = 0; x < width; x += hn::Lanes(floats)) {
    const auto depth = hn::Sub(one, hn::LoadU(floats, reversed_depth + x));
    store(hn::BitCast(words, depth), reinterpret_cast<std::uint32_t*>(out + x));
  }
}

/// One row's planes.
struct Row {
  const std::uint32_t* ids;
  const float* reversed_depth;
  std::uint8_t* colour;
  float* depth;
};
HWY_INLINE Row row_of(const PlainRows& rows, std::ptrdiff_t y) {
  return {rows.ids + y * rows.ids_stride, rows.reversed_depth + y * rows.reversed_depth_stride,
          rows.colour == nullptr ? nullptr : rows.colour + 4 * y * rows.colour_stride,
          rows.depth == nullptr ? nullptr : rows.depth + y * rows.depth_stride};
}

template <typename Store>
HWY_INLINE std::size_t shade_whole_vectors(const Row& row, std::size_t width, Colours& colours,
                                           const Store& store) {
  if (row.depth != nullptr) write_depths(row.reversed_depth, width, row.depth, store);
  return shade_colours(row.ids, width, colours, row.colour, store);
}

/// The last pixels of a row, fewer than a vector has. @return how many are hidden
HWY_INLINE std::size_t shade_rest(const Row& row, std::size_t x, std::size_t width, Colours& colours) {
  HWY_ALIGN std::uint32_t rest[hn::MaxLanes(words)];
  HWY_ALIGN std::uint8_t coloured[4 * hn::MaxLanes(words)];
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < hn::MaxLanes(words); ++i) {
    rest[i] = row.ids[x + i < width ? x + i : width - 1];
    hidden += x + i < width && rest[i] == background_id;
    if (x + i < width && row.depth != nullptr) row.depth[x + i] = 1.0f - row.reversed_depth[x + i];
  }
  if (row.colour == nullptr) return hidden;
  shade_colours(rest, hn::MaxLanes(words), colours, coloured, Storing{});
  __builtin_memcpy(row.colour + 4 * x, coloured, 4 * (width - x));
  return hidden;
}

bool is_aligned(const Row& row) {
  constexpr std::uintptr_t vector_bytes = hn::MaxLanes(words) * sizeof(std::uint32_t);
  const std::uintptr_t places =
      reinterpret_cast<std::uintptr_t>(row.colour) | reinterpret_cast<std::uintptr_t>(row.depth);
  return places % vector_bytes == 0;
}

}  // namespace

std::uint64_t shade_plain_rows(const PlainRows& rows) {
  const auto width = static_cast<std::size_t>(rows.width);
  const std::size_t whole = width - width % hn::Lanes(words);
  Colours colours(rows.background);
  std::uint64_t hidden = 0;
  for (std::ptrdiff_t y = 0; y < rows.height; ++y) {
    const Row row = row_of(rows, y);
    hidden += rows.is_large && is_aligned(row) ? shade_whole_vectors(row, whole, colours, Streaming{})
                                               : shade_whole_vectors(row, whole, colours, Storing{});
    if (whole < width) hidden += shade_rest(row, whole, width, colours);
  }
  if (rows.is_large) hwy::FlushStream();
  return static_cast<std::uint64_t>(rows.height) * width - hidden;
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

ShadePlainRows plain_rows_kernel(Isa isa) {
  static constexpr auto versions = VELUM_KERNEL_VERSIONS(shade_plain_rows);
  return isa == Isa::reference ? shade_plain_rows_reference : versions.at(isa);
}

}  // namespace velum
#endif
