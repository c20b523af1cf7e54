#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "ply_header.hpp"
#include "text_scanner.hpp"

namespace velum {

/// The values behind a PLY header, one after the other, in whichever encoding.
class PlyValues {
 public:
  PlyValues(std::span<const std::byte> bytes, const PlyHeader& header, const std::string& name);

  /// Rounded once, from what stands in the file. @throws Error (read) where the file ends or holds no number
  float real(PlyType type);
  /// Also 3.0 for 3 in text. @throws Error (read)
  std::int64_t integer(PlyType type);
  void skip(PlyType type);

  /// Demands that `count` values of at least this size can still follow. @param what  "vertices", …
  void require(std::uint64_t count, std::size_t bytes_each, const char* what) const;
  /// The least number of bytes a value of this type takes.
  std::size_t least_size(PlyType type) const { return is_text_ ? 2 : size_of(type); }

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy = {}) const;

 private:
  const std::byte* take(std::size_t size);
  std::string_view take_word();

  std::span<const std::byte> bytes_;
  std::size_t position_;
  std::endian order_;
  bool is_text_;
  std::size_t lines_before_;
  std::string name_;
  TextScanner text_;
};

}  // namespace velum
