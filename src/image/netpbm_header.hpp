#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "image.hpp"

namespace velum {

/// Reads the text header that PPM and PFM share: words between white space, comments from # to the line's
/// end.
/// @throws Error (read) in every function
class NetpbmHeader {
 public:
  /// @param format for messages, e.g. "PPM"; @param name how they call the file
  NetpbmHeader(std::span<const std::byte> bytes, const char* format, std::string name);

  std::string_view word();
  /// A word that is a whole number from 1 to max_image_side.
  int side();
  /// What follows the one white-space character after the header: at least rows·row_bytes bytes.
  const std::byte* payload(int rows, std::size_t row_bytes);

  [[noreturn]] void fail(const std::string& problem) const;

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  const char* format_;
  std::string name_;
};

}  // namespace velum
