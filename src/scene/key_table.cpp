#include "key_table.hpp"

namespace velum {
namespace {

constexpr std::uint32_t empty_slot = 0xFFFFFFFFu;

// The finaliser of SplitMix64 (Steele, Lea & Flood 2014) over the three words.
std::uint64_t mixed(const glm::uvec3& key) {
  std::uint64_t h = (std::uint64_t{key.x} << 32 | key.y) + 0x9E3779B97F4A7C15ull * (std::uint64_t{key.z} + 1);
  h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9ull;
  h = (h ^ (h >> 27)) * 0x94D049BB133111EBull;
  return h ^ (h >> 31);
}

}  // namespace

std::size_t KeyTable::slot_of(const glm::uvec3& key) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = static_cast<std::size_t>(mixed(key)) & mask;
  while (slots_[slot] != empty_slot && keys_[slots_[slot]] != key) slot = (slot + 1) & mask;
  return slot;
}

std::uint32_t KeyTable::number_of(const glm::uvec3& key) {
  if (2 * keys_.size() >= slots_.size()) grow();
  std::uint32_t& number = slots_[slot_of(key)];
  if (number == empty_slot) {
    number = static_cast<std::uint32_t>(keys_.size());
    keys_.push_back(key);
  }
  return number;
}

void KeyTable::grow() {
  const std::size_t size = slots_.empty() ? 16 : 2 * slots_.size();
  slots_ = {};
  slots_.assign(size, empty_slot);
  for (std::size_t i = 0; i < keys_.size(); ++i) slots_[slot_of(keys_[i])] = static_cast<std::uint32_t>(i);
}

}  // namespace velum
