#include "contract.hpp"

namespace velum {

void contract_violation(const char* function, const char* condition,
                        std::initializer_list<ContractValue> values) {
  std::string text = std::string(function) + ": the contract " + condition + " is broken";
  const char* separator = ": ";
  for (const ContractValue& value : values) {
    text += separator;
    text += value.name;
    text += " = " + value.text;
    separator = ", ";
  }
  throw ContractViolation(text);
}

}  // namespace velum
