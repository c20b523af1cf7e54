#pragma once

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "allocation.hpp"
#include "base/error.hpp"
#include "random.hpp"
#include "scene/load_scene.hpp"

inline std::span<const std::byte> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::byte*>(text.data()), text.size()};
}

inline velum::Scene read(std::string_view text, const std::string& name, velum::MissingNormals missing = {}) {
  return velum::load_scene_from_memory(bytes_of(text), name, {}, {missing});
}

/// The message of the Error (read) that reading throws; empty when it does not.
inline std::string failure(std::string_view text, const std::string& name,
                           velum::MissingNormals missing = {}) {
  try {
    read(text, name, missing);
  } catch (const velum::Error& error) {
    CHECK(error.kind() == velum::ErrorKind::read);
    return error.what();
  }
  return {};
}

inline bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

/// Reading these bytes ends, with a scene or an Error (read), within the memory that load_scene promises.
inline void check_survives(std::string_view text, const std::string& name) {
  for (const auto missing : {velum::MissingNormals::smooth, velum::MissingNormals::flat}) {
    const AllocationWatch watch;
    failure(text, name, missing);
    CHECK(watch.peak() <= 64 * text.size() + (std::size_t{1} << 20));
  }
}

/// One to four bytes changed, a piece cut out, doubled or moved.
inline std::string mutated(std::string_view original, Random& random) {
  std::string text(original);
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random.next() % n); };
  for (std::size_t i = 0, n = 1 + below(4); i < n && !text.empty(); ++i) {
    const std::size_t at = below(text.size()),
                      length = 1 + below(std::min<std::size_t>(16, text.size() - at));
    constexpr std::string_view telling = "0123456789-+.eE/ \n\r\\#\xFF";
    switch (below(6)) {
      case 0:
        text[at] = static_cast<char>(random.next());
        break;
      case 1:
        text[at] = telling[below(telling.size())];
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(below(text.size()), text.substr(at, length));
        break;
      case 4:
        text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      default:
        text.insert(at, 1, telling[below(telling.size())]);
        break;
    }
  }
  return text;
}

/// Every beginning of the file, and seeded mutations of it.
inline void check_prefixes_and_mutations(std::string_view text, const std::string& name, int mutations,
                                         std::uint64_t seed) {
  for (std::size_t length = 0; length < text.size(); ++length) check_survives(text.substr(0, length), name);
  Random random{seed};
  for (int i = 0; i < mutations; ++i) {
    const std::string changed = mutated(text, random);
    CAPTURE(changed);
    check_survives(changed, name);
  }
}
