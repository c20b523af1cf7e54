#include "short_number.hpp"

#include <array>
#include <charconv>

#include "../base/contract.hpp"

namespace velum {

std::string short_number(double value, int digits) {
  VELUM_REQUIRE(digits >= 1 && digits <= 17, {"digits", digits});
  std::array<char, 32> buffer;
  const double without_sign_of_zero = value == 0.0 ? 0.0 : value;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), without_sign_of_zero,
                                    std::chars_format::general, digits);
  return {buffer.data(), result.ptr};
}

}  // namespace velum
