#include "kd_file.hpp"

#include <array>
#include <bit>
#include <cstring>

#include "../../base/error.hpp"
#include "../../image/bytes.hpp"
#include "../../image/file_bytes.hpp"
#include "kd_check.hpp"

namespace velum {
namespace {

static_assert(sizeof(KdNode) == 8 && sizeof(glm::vec3) == 12 && sizeof(glm::uvec3) == 12);

/// Of words of 4 bytes. For a given rest each word has another result, so no change of one word stays unseen.
class WordHash {
 public:
  void add(const void* memory, std::size_t words) {
    const auto* bytes = static_cast<const std::byte*>(memory);
    for (std::size_t i = 0; i < words; ++i) {
      std::uint32_t word = 0;
      std::memcpy(&word, bytes + 4 * i, 4);
      value_ = (std::rotl(value_, 23) ^ word) * 0x9E3779B97F4A7C15u;
    }
  }
  std::uint64_t value() const { return value_ ^ (value_ >> 32); }

 private:
  std::uint64_t value_ = 0x76656C756D6B6474u;
};

std::uint64_t fingerprint(const TriangleSet& triangles) {
  WordHash hash;
  hash.add(triangles.positions.data(), triangles.positions.size() * 3);
  hash.add(triangles.triangles.data(), triangles.triangles.size() * 3);
  return hash.value();
}

/// The header's words of 4 bytes; numbers of 64 bits have their lower half first.
struct Header {
  std::array<char, 8> magic{'v', 'e', 'l', 'u', 'm', '-', 'k', 'd'};
  std::uint32_t version = 1;
  std::uint32_t nodes = 0, ids = 0, triangles = 0;
  std::array<std::uint32_t, 2> fingerprint{};
  std::array<std::uint32_t, 2> pad{};
  std::array<float, 6> cell{};
  std::uint32_t reaches = 0, unused = 0;
  std::array<std::uint32_t, 2> checksum{};

  /// Bytes of the file that has this header.
  std::uint64_t file_size() const {
    return sizeof(Header) + std::uint64_t{nodes} * sizeof(KdNode) + std::uint64_t{ids} * 4 +
           std::uint64_t{reaches} * 4;
  }
};
constexpr std::size_t magic_words = 2, header_words = 20, hashed_header_words = 18;
static_assert(sizeof(Header) == header_words * 4);

std::array<std::uint32_t, 2> halves(std::uint64_t v) {
  return {static_cast<std::uint32_t>(v), static_cast<std::uint32_t>(v >> 32)};
}
std::uint64_t whole(const std::array<std::uint32_t, 2>& v) {
  return v[0] | std::uint64_t{v[1]} << 32;
}

/// Calls action(memory, words) for each array that is not empty, in the order they have in a file.
template <typename Tree, typename Action>
void for_each_array(Tree& tree, const Action& action) {
  if (!tree.nodes.empty()) action(tree.nodes.data(), tree.nodes.size() * 2);
  if (!tree.ids.empty()) action(tree.ids.data(), tree.ids.size());
  if (!tree.reaches.empty()) action(tree.reaches.data(), tree.reaches.size());
}

std::array<std::uint32_t, 2> checksum(const Header& header, const KdArrays& tree) {
  WordHash hash;
  hash.add(&header, hashed_header_words);
  for_each_array(tree, [&hash](const void* memory, std::size_t words) { hash.add(memory, words); });
  return halves(hash.value());
}

Header header_of(const KdTree& tree) {
  const KdArrays& arrays = tree.arrays();
  Header header;
  header.nodes = static_cast<std::uint32_t>(arrays.nodes.size());
  header.ids = static_cast<std::uint32_t>(arrays.ids.size());
  header.reaches = static_cast<std::uint32_t>(arrays.reaches.size());
  header.triangles = tree.triangles().size();
  header.fingerprint = halves(fingerprint(tree.triangles()));
  header.pad = halves(std::bit_cast<std::uint64_t>(arrays.pad));
  for (int i = 0; i < 6; ++i) {
    header.cell[static_cast<std::size_t>(i)] = i < 3 ? arrays.cell.lower[i] : arrays.cell.upper[i - 3];
  }
  header.checksum = checksum(header, arrays);
  return header;
}

/// Header and file hold the words in little-endian order; the magic is no word.
void copy_header(void* to, const void* from) {
  auto* target = static_cast<std::byte*>(to);
  const auto* source = static_cast<const std::byte*>(from);
  std::memcpy(target, source, magic_words * 4);
  copy_little_endian(target + magic_words * 4, source + magic_words * 4, header_words - magic_words);
}

/// @pre bytes are as many as the header says
KdArrays arrays_from(const Header& header, std::span<const std::byte> bytes) {
  KdArrays tree;
  tree.nodes.resize(header.nodes);
  tree.ids.resize(header.ids);
  tree.reaches.resize(header.reaches);
  const std::byte* next = bytes.data() + sizeof(Header);
  for_each_array(tree, [&next](void* memory, std::size_t words) {
    copy_little_endian(memory, next, words);
    next += 4 * words;
  });
  tree.pad = std::bit_cast<double>(whole(header.pad));
  for (int i = 0; i < 6; ++i) {
    (i < 3 ? tree.cell.lower[i] : tree.cell.upper[i - 3]) = header.cell[static_cast<std::size_t>(i)];
  }
  return tree;
}

[[noreturn]] void refuse(const std::string& problem, const std::string& where) {
  throw Error(ErrorKind::read, problem, where, "build the kd-tree again and save it");
}

Header read_header(std::span<const std::byte> bytes, const std::string& where) {
  Header header;
  const auto magic = header.magic;
  const std::uint32_t version = header.version;
  if (bytes.size() >= sizeof(Header)) copy_header(&header, bytes.data());
  if (bytes.size() < sizeof(Header) || header.magic != magic) {
    throw Error(ErrorKind::read, "is no kd-tree that velum saved", where, "check the path");
  }
  if (header.version != version) {
    refuse("is a kd-tree of version " + std::to_string(header.version) + "; this velum reads version " +
               std::to_string(version),
           where);
  }
  if (header.file_size() != bytes.size()) {
    refuse("has " + std::to_string(bytes.size()) + " bytes where its header announces " +
               std::to_string(header.file_size()),
           where);
  }
  return header;
}

}  // namespace

std::vector<std::byte> kd_tree_bytes(const KdTree& tree) {
  const Header header = header_of(tree);
  std::vector<std::byte> bytes(static_cast<std::size_t>(header.file_size()));
  copy_header(bytes.data(), &header);
  std::byte* next = bytes.data() + sizeof(Header);
  for_each_array(tree.arrays(), [&next](const void* memory, std::size_t words) {
    copy_little_endian(next, memory, words);
    next += 4 * words;
  });
  return bytes;
}

std::unique_ptr<KdTree> kd_tree_from_bytes(std::span<const std::byte> bytes, const TriangleSet& triangles,
                                           const std::string& where, KdWalk walk) {
  const Header header = read_header(bytes, where);
  KdArrays tree = arrays_from(header, bytes);
  if (checksum(header, tree) != header.checksum) {
    refuse("is a damaged kd-tree: its checksum does not match", where);
  }
  if (header.triangles != triangles.size() || whole(header.fingerprint) != fingerprint(triangles)) {
    refuse("is a kd-tree over other triangles than these", where);
  }
  const std::string fault = fault_in(tree, triangles.size());
  if (!fault.empty()) refuse("is no sound kd-tree: " + fault, where);
  return std::make_unique<KdTree>(triangles, std::move(tree), walk);
}

void save_kd_tree(const std::filesystem::path& path, const KdTree& tree) {
  write_file(path, kd_tree_bytes(tree));
}

std::unique_ptr<KdTree> load_kd_tree(const std::filesystem::path& path, const TriangleSet& triangles,
                                     KdWalk walk) {
  return kd_tree_from_bytes(read_file(path), triangles, input_name(path), walk);
}

void mend_kd_checksum(std::span<std::byte> bytes) {
  if (bytes.size() < sizeof(Header)) return;
  Header header;
  copy_header(&header, bytes.data());
  if (header.file_size() != bytes.size()) return;
  header.checksum = checksum(header, arrays_from(header, bytes));
  copy_header(bytes.data(), &header);
}

}  // namespace velum
