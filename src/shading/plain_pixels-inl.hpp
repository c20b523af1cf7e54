// Colours and depths of pixels whose colour depends on the primitive's id alone; wherever the ids stand.
// Highway reads this file once per instruction set, so its guard turns with the target.
#if defined(VELUM_PLAIN_PIXELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_PLAIN_PIXELS_INL
#undef VELUM_PLAIN_PIXELS_INL
#else
#define VELUM_PLAIN_PIXELS_INL
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "plain_rows.hpp"

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
  HWY_INLINE explicit Colours(const std::uint8_t* background_rgba) {
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

/// One row of the outputs.
struct PlainRow {
  std::uint32_t* colour;
  std::uint32_t* depth;
  std::uint32_t* ids;

  HWY_INLINE PlainRow(const PlainOutput& out, std::ptrdiff_t y)
      : colour(out.colour == nullptr
                   ? nullptr
                   : reinterpret_cast<std::uint32_t*>(out.colour + 4 * y * out.colour_stride)),
        depth(out.depth == nullptr ? nullptr
                                   : reinterpret_cast<std::uint32_t*>(out.depth + y * out.depth_stride)),
        ids(out.ids == nullptr ? nullptr : out.ids + y * out.ids_stride) {}

  HWY_INLINE bool is_aligned() const {
    const std::uintptr_t places = reinterpret_cast<std::uintptr_t>(colour) |
                                  reinterpret_cast<std::uintptr_t>(depth) |
                                  reinterpret_cast<std::uintptr_t>(ids);
    return places % (hn::MaxLanes(words) * sizeof(std::uint32_t)) == 0;
  }
};

HWY_INLINE Word depth_of(Word reversed_depth) {
  return hn::BitCast(words, hn::Sub(hn::Set(floats, 1.0f), hn::BitCast(floats, reversed_depth)));
}

/// The first `width` pixels of a row, a whole number of vectors. @return how many are hidden
template <typename Source, typename Store>
HWY_INLINE std::size_t shade_whole_vectors(const Source& source, std::size_t width, Colours& colours,
                                           const PlainRow& out, const Store& store) {
  const std::size_t lanes = hn::Lanes(words);
  const Word nothing = hn::Set(words, background_id);
  for (std::size_t x = 0; out.depth != nullptr && x < width; x += lanes) {
    store(depth_of(source.reversed_depths(x)), out.depth + x);
  }
  std::size_t hidden = 0;
  for (std::size_t x = 0; x < width; x += lanes) {
    const Word id = source.ids(x);
    hidden += hn::CountTrue(words, hn::Eq(id, nothing));
    if (out.colour != nullptr) store(colours.of(id, source.id_at(x + lanes - 1)), out.colour + x);
    if (out.ids != nullptr) store(id, out.ids + x);
  }
  return hidden;
}

/// The last pixels of a row, fewer than a vector has. @return how many are hidden
template <typename Source>
HWY_INLINE std::size_t shade_rest(const Source& source, std::size_t first, std::size_t width,
                                  Colours& colours, const PlainRow& out) {
  HWY_ALIGN std::uint32_t rest[hn::MaxLanes(words)];
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < hn::MaxLanes(words); ++i)
    rest[i] = source.id_at(first + i < width ? first + i : first);
  for (std::size_t x = first; x < width; ++x) {
    hidden += rest[x - first] == background_id;
    if (out.ids != nullptr) out.ids[x] = rest[x - first];
    if (out.depth == nullptr) continue;
    const float depth = 1.0f - source.reversed_depth_at(x);
    __builtin_memcpy(out.depth + x, &depth, sizeof depth);
  }
  if (out.colour == nullptr) return hidden;
  HWY_ALIGN std::uint32_t coloured[hn::MaxLanes(words)];
  hn::Store(colours.of(hn::Load(words, rest), rest[hn::MaxLanes(words) - 1]), words, coloured);
  __builtin_memcpy(out.colour + first, coloured, sizeof(std::uint32_t) * (width - first));
  return hidden;
}

/// @param rows  rows.row(y) gives a row's ids(x) and reversed_depths(x), a vector of pixels x and on, and
///              id_at(x) and reversed_depth_at(x)
/// @return the number of visible pixels
template <typename Rows>
HWY_INLINE std::uint64_t shade_plain(const Rows& rows, std::size_t width, std::size_t height,
                                     const PlainOutput& out) {
  const std::size_t whole = width - width % hn::Lanes(words);
  Colours colours(out.background);
  std::uint64_t hidden = 0;
  for (std::size_t y = 0; y < height; ++y) {
    const auto source = rows.row(y);
    const PlainRow row(out, static_cast<std::ptrdiff_t>(y));
    hidden += out.is_large && row.is_aligned() ? shade_whole_vectors(source, whole, colours, row, Streaming{})
                                               : shade_whole_vectors(source, whole, colours, row, Storing{});
    if (whole < width) hidden += shade_rest(source, whole, width, colours, row);
  }
  if (out.is_large) hwy::FlushStream();
  return height * width - hidden;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif  // the guard that turns with the target
