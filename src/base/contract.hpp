#pragma once

#include <initializer_list>
#include <sstream>
#include <stdexcept>
#include <string>

namespace velum {

/// A broken caller contract: names the function, the condition and the values that broke it.
class ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// One value of a violated contract, as text.
struct ContractValue {
  template <typename T>
  ContractValue(const char* name_in, const T& value) : name(name_in) {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    stream.precision(17);
    stream << value;
    text = stream.str();
  }
  const char* name;
  std::string text;
};

/// Throws ContractViolation: "function: condition is broken: name = value, …".
[[noreturn]] void contract_violation(const char* function, const char* condition,
                                     std::initializer_list<ContractValue> values);

}  // namespace velum

/// Demands `condition` of the caller; further arguments are {"name", value} pairs that the message prints.
/// Always on: the cost is one branch at a public boundary, never in a kernel.
#define VELUM_REQUIRE(condition, ...)                                                   \
  do {                                                                                  \
    if (!(condition)) ::velum::contract_violation(__func__, #condition, {__VA_ARGS__}); \
  } while (false)
