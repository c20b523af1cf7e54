#include "ply_values.hpp"

#include <limits>

#include "../base/error.hpp"
#include "byte_order.hpp"

namespace velum {
namespace {

constexpr const char* cut_off = "check that the file is whole, or export it again";

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// A double beyond the range of float would be undefined to convert.
float narrowed(double value) {
  constexpr double largest = std::numeric_limits<float>::max();
  constexpr double halfway = 0x1.ffffffp127;  // from here on the nearest float is infinite
  if (value >= halfway) return std::numeric_limits<float>::infinity();
  if (value <= -halfway) return -std::numeric_limits<float>::infinity();
  if (value > largest) return std::numeric_limits<float>::max();
  if (value < -largest) return -std::numeric_limits<float>::max();
  return static_cast<float>(value);
}

}  // namespace

PlyValues::PlyValues(std::span<const std::byte> bytes, const PlyHeader& header, const std::string& name)
    : bytes_(bytes),
      position_(header.size),
      order_(header.encoding == PlyEncoding::big_endian ? std::endian::big : std::endian::little),
      is_text_(header.encoding == PlyEncoding::ascii),
      lines_before_(header.line_count),
      name_(name),
      text_(as_text(bytes.subspan(header.size)), name) {}

const std::byte* PlyValues::take(std::size_t size) {
  if (bytes_.size() - position_ < size) fail("the file ends too early", cut_off);
  const std::byte* at = bytes_.data() + position_;
  position_ += size;
  return at;
}

std::string_view PlyValues::take_word() {
  const std::string_view word = text_.word();
  if (word.empty()) fail("the file ends too early", cut_off);
  return word;
}

float PlyValues::real(PlyType type) {
  if (is_text_) {
    const std::string_view word = take_word();
    if (const std::optional<float> value = parse_float(word)) return *value;
    fail("not a number: " + quoted(word));
  }
  if (type == PlyType::float32) return load_float(take(4), order_);
  if (type == PlyType::float64) return narrowed(load_double(take(8), order_));
  return static_cast<float>(integer(type));
}

std::int64_t PlyValues::integer(PlyType type) {
  if (is_text_) {
    const std::string_view word = take_word();
    if (const std::optional<std::int64_t> value = parse_integer(word)) return *value;
    constexpr double exact = 0x1p53;
    const double value = parse_double(word).value_or(exact);
    const bool is_whole =
        value > -exact && value < exact && value == static_cast<double>(static_cast<std::int64_t>(value));
    if (!is_whole) fail("not a whole number: " + quoted(word));
    return static_cast<std::int64_t>(value);
  }
  switch (type) {
    case PlyType::int8:
      return load_integer<std::int8_t>(take(1), order_);
    case PlyType::uint8:
      return load_integer<std::uint8_t>(take(1), order_);
    case PlyType::int16:
      return load_integer<std::int16_t>(take(2), order_);
    case PlyType::uint16:
      return load_integer<std::uint16_t>(take(2), order_);
    case PlyType::int32:
      return load_integer<std::int32_t>(take(4), order_);
    case PlyType::uint32:
      return load_integer<std::uint32_t>(take(4), order_);
    case PlyType::float32:
    case PlyType::float64:
      break;
  }
  fail("a whole number is expected where the header has a real one");
}

void PlyValues::skip(PlyType type) {
  if (is_text_)
    take_word();
  else
    take(size_of(type));
}

void PlyValues::require(std::uint64_t count, std::size_t bytes_each, const char* what) const {
  // The last value of a text needs no blank behind it.
  const std::size_t left =
      is_text_ ? bytes_.size() - position_ - text_.position() + 1 : bytes_.size() - position_;
  if (bytes_each == 0 || count <= left / bytes_each) return;
  fail(std::to_string(count) + " " + what + " are announced, more than the rest of the file can hold",
       cut_off);
}

void PlyValues::fail(const std::string& problem, const std::string& remedy) const {
  const std::string where = is_text_ ? name_ + ":" + std::to_string(lines_before_ + text_.line())
                                     : name_ + ": byte " + std::to_string(position_);
  throw Error(ErrorKind::read, problem, where, remedy);
}

}  // namespace velum
