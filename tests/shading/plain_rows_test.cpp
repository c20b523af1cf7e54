#include "shading/plain_rows.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <limits>
#include <vector>

#include "image/visibility_buffer.hpp"
#include "random.hpp"

using namespace velum;

namespace {

/// Rows with room around them, which must stay as it is.
struct Buffers {
  int width, height;
  std::ptrdiff_t stride;
  std::vector<std::uint32_t> ids;
  std::vector<float> reversed_depth;
  std::vector<std::uint8_t> colour;
  std::vector<float> depth;
  std::vector<std::uint32_t> ids_out;
  bool is_large = false;

  Buffers(int w, int h, int room) : width(w), height(h), stride(w + room) {
    const auto size = static_cast<std::size_t>(stride * h);
    ids.resize(size);
    reversed_depth.resize(size);
    colour.assign(4 * size, 77);
    depth.assign(size, -7.0f);
    ids_out.assign(size, 5);
  }

  PlainRows rows(bool with_colour, bool with_depth, bool with_ids = true) {
    PlainOutput out{nullptr, 0, nullptr, 0, nullptr, 0, {9, 8, 7, 6}, is_large};
    if (with_colour) out.colour = colour.data(), out.colour_stride = stride;
    if (with_depth) out.depth = depth.data(), out.depth_stride = stride;
    if (with_ids) out.ids = ids_out.data(), out.ids_stride = stride;
    return {width, height, ids.data(), stride, reversed_depth.data(), stride, out};
  }
};

void check_against_reference(const Buffers& input) {
  for (const bool with_colour : {true, false}) {
    for (const bool with_depth : {true, false}) {
      Buffers expected = input;
      const std::uint64_t visible = shade_plain_rows_reference(expected.rows(with_colour, with_depth));
      for (const Isa isa : available_isas()) {
        CAPTURE(name_of(isa));
        Buffers actual = input;
        CHECK(plain_rows_kernel(isa)(actual.rows(with_colour, with_depth)) == visible);
        CHECK(actual.colour == expected.colour);
        CHECK(actual.depth == expected.depth);
        CHECK(actual.ids_out == expected.ids_out);
        actual = input;
        actual.is_large = true;
        CHECK(plain_rows_kernel(isa)(actual.rows(with_colour, with_depth)) == visible);
        CHECK(actual.colour == expected.colour);
        CHECK(actual.depth == expected.depth);
        CHECK(actual.ids_out == expected.ids_out);
      }
    }
  }
}

/// Runs of one id, 1 … longest pixels long.
void fill_with_runs(Random& random, int longest, Buffers& buffers) {
  int left = 0;
  std::uint32_t id = 0;
  for (std::size_t i = 0; i < buffers.ids.size(); ++i, --left) {
    if (left == 0) {
      left = 1 + random.below(longest);
      const int kind = random.below(4);
      id = kind == 0 ? no_primitive : static_cast<std::uint32_t>(random.next() >> (kind == 1 ? 32 : 48));
    }
    buffers.ids[i] = id;
    buffers.reversed_depth[i] = id == no_primitive ? 0.0f : static_cast<float>(random.uniform());
  }
}

}  // namespace

TEST_CASE("rows of id colours: the vector versions give the reference's bytes") {
  Random random{41};
  for (const int width : {1, 3, 7, 8, 15, 16, 17, 31, 64, 65, 203}) {
    for (const int longest : {1, 5, 40}) {
      Buffers buffers(width, 3, random.below(9));
      fill_with_runs(random, longest, buffers);
      check_against_reference(buffers);
    }
  }
}

TEST_CASE("rows of id colours: ids at the ends of their range and in every sector of hue") {
  Buffers buffers(4096, 2, 0);
  for (std::size_t i = 0; i < buffers.ids.size(); ++i) {
    const auto n = static_cast<std::uint32_t>(i);
    buffers.ids[i] = i < 4096 ? n : 0xFFFFFFFFu - (n - 4096);
    buffers.reversed_depth[i] = std::bit_cast<float>(n * 130000u % 0x3F800001u);
  }
  check_against_reference(buffers);
}

TEST_CASE("[long] rows of id colours: sixteen million ids") {
  Random random{42};
  for (int round = 0; round < 256; ++round) {
    Buffers buffers(65536, 1, 0);
    for (std::uint32_t& id : buffers.ids) id = static_cast<std::uint32_t>(random.next());
    check_against_reference(buffers);
  }
}

TEST_CASE("rows of id colours: what is hidden is not counted, and shows the background at depth 1") {
  Buffers buffers(5, 1, 0);
  buffers.ids = {no_primitive, 3, no_primitive, 0, 0xFFFFFFFEu};
  buffers.reversed_depth = {0.0f, 1.0f, 0.0f, 0.25f, std::numeric_limits<float>::denorm_min()};
  for (const Isa isa : available_isas()) {
    CHECK(plain_rows_kernel(isa)(buffers.rows(true, true)) == 3);
    CHECK(buffers.depth == std::vector<float>{1.0f, 0.0f, 1.0f, 0.75f, 1.0f});
    CHECK(buffers.colour[0] == 9);
    CHECK(buffers.colour[11] == 6);
    CHECK(buffers.colour[7] == 255);
  }
}
