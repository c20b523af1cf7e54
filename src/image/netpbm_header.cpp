#include "netpbm_header.hpp"

#include <charconv>
#include <utility>

#include "../base/error.hpp"

namespace velum {
namespace {

bool is_space(std::byte byte) {
  const char c = static_cast<char>(byte);
  return c == ' ' || (c >= '\t' && c <= '\r');
}

}  // namespace

NetpbmHeader::NetpbmHeader(std::span<const std::byte> bytes, const char* format, std::string name)
    : bytes_(bytes), format_(format), name_(std::move(name)) {}

void NetpbmHeader::fail(const std::string& problem) const {
  throw Error(ErrorKind::read, std::string("not a readable ") + format_ + ": " + problem, name_,
              "save the picture again, or convert it with another program");
}

std::string_view NetpbmHeader::word() {
  while (at_ < bytes_.size() && (is_space(bytes_[at_]) || bytes_[at_] == std::byte{'#'})) {
    if (bytes_[at_] == std::byte{'#'}) {
      while (at_ < bytes_.size() && bytes_[at_] != std::byte{'\n'}) ++at_;
    } else {
      ++at_;
    }
  }
  const std::size_t begin = at_;
  while (at_ < bytes_.size() && !is_space(bytes_[at_])) ++at_;
  if (at_ == bytes_.size()) fail("the file ends within its header");
  return {reinterpret_cast<const char*>(bytes_.data()) + begin, at_ - begin};
}

int NetpbmHeader::side() {
  const std::string_view text = word();
  int value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = status == std::errc{} && end == text.data() + text.size();
  if (!is_number || value < 1 || value > max_image_side) {
    fail("its width and height must be whole numbers from 1 to 32768");
  }
  return value;
}

const std::byte* NetpbmHeader::payload(int rows, std::size_t row_bytes) {
  ++at_;  // word() stopped at a white-space character
  const std::size_t needed = static_cast<std::size_t>(rows) * row_bytes;
  const std::size_t available = bytes_.size() - at_;
  if (available < needed) {
    fail("the header announces " + std::to_string(needed) + " bytes of pixels, but " +
         std::to_string(available) + " follow");
  }
  return bytes_.data() + at_;
}

}  // namespace velum
