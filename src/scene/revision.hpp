#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>

namespace velum {

/// A running hash over the changes made to a Scene. It needs no shared counter, so the library keeps no
/// global state, and yet two Scenes that differ (a copy changed afterwards, another Scene at the same
/// address) have different revisions. Not stable between machines: it is a key, never written to a file.
///
/// The mixing step is the finalizer of SplitMix64 (Steele, Lea & Flood, "Fast Splittable Pseudorandom Number
/// Generators", 2014), with the word added before it.
class RevisionHash {
 public:
  explicit RevisionHash(std::uint64_t revision) : state_(revision) {}

  RevisionHash& word(std::uint64_t value) {
    state_ += value + 0x9E3779B97F4A7C15u;
    state_ = (state_ ^ (state_ >> 30)) * 0xBF58476D1CE4E5B9u;
    state_ = (state_ ^ (state_ >> 27)) * 0x94D049BB133111EBu;
    state_ ^= state_ >> 31;
    return *this;
  }

  /// The length and every byte. @pre T has no padding
  template <typename T>
  RevisionHash& values(const T* data, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::size_t size = count * sizeof(T);
    word(size);
    const unsigned char* bytes = reinterpret_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; i += sizeof(std::uint64_t)) {
      std::uint64_t value = 0;
      const std::size_t left = size - i;
      std::memcpy(&value, bytes + i, left < sizeof value ? left : sizeof value);
      word(value);
    }
    return *this;
  }
  template <typename T>
  RevisionHash& value(const T& single) {
    return values(&single, 1);
  }
  RevisionHash& text(const std::string& characters) { return values(characters.data(), characters.size()); }

  std::uint64_t result() const { return state_; }

 private:
  std::uint64_t state_;
};

}  // namespace velum
