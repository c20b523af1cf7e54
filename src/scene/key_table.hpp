#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace velum {

/// Numbers distinct keys 0, 1, 2, … in the order in which they first appear: vertices that are equal get the
/// same number. Open addressing; takes 20 to 40 bytes per distinct key.
class KeyTable {
 public:
  std::uint32_t number_of(const glm::uvec3& key);
  const std::vector<glm::uvec3>& keys() const { return keys_; }

 private:
  std::size_t slot_of(const glm::uvec3& key) const;
  void grow();

  std::vector<glm::uvec3> keys_;
  std::vector<std::uint32_t> slots_;  // number of the key, or 0xFFFFFFFF; a power of two, at most half full
};

}  // namespace velum
