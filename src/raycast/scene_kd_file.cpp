#include "scene_kd_file.hpp"

#include <array>
#include <cstring>

#include "../base/contract.hpp"
#include "../base/error.hpp"
#include "../image/file_bytes.hpp"
#include "kd/kd_file.hpp"

namespace velum {
namespace {

constexpr std::array<char, 8> magic{'v', 'e', 'l', 'u', 'm', '-', 'k', 's'};
constexpr std::uint32_t version = 1;
constexpr std::size_t header_size = 16, size_size = 8;

template <typename Word>
void append(std::vector<std::byte>& bytes, Word value) {
  for (std::size_t i = 0; i < sizeof(Word); ++i) bytes.push_back(static_cast<std::byte>(value >> 8 * i));
}

template <typename Word>
Word word_at(std::span<const std::byte> bytes, std::size_t at) {
  Word value = 0;
  for (std::size_t i = 0; i < sizeof(Word); ++i) {
    value |= static_cast<Word>(std::to_integer<Word>(bytes[at + i]) << 8 * i);
  }
  return value;
}

[[noreturn]] void refuse(const std::string& problem, const std::string& where) {
  throw Error(ErrorKind::read, problem, where, "build the kd-trees again and save them");
}

/// @return the number of meshes
std::uint32_t check_header(std::span<const std::byte> bytes, const std::string& where) {
  if (bytes.size() < header_size || std::memcmp(bytes.data(), magic.data(), magic.size()) != 0) {
    throw Error(ErrorKind::read, "is no file of kd-trees that velum saved", where, "check the path");
  }
  const auto found = word_at<std::uint32_t>(bytes, magic.size());
  if (found != version) {
    refuse("has kd-trees of version " + std::to_string(found) + "; this velum reads version " +
               std::to_string(version),
           where);
  }
  return word_at<std::uint32_t>(bytes, magic.size() + 4);
}

}  // namespace

std::vector<std::byte> kd_trees_bytes(const SceneCaster& caster) {
  VELUM_REQUIRE(caster.kind() == AcceleratorKind::kd_tree, {"kind", static_cast<int>(caster.kind())});
  std::vector<std::vector<std::byte>> trees;
  for (std::uint32_t mesh = 0; mesh < caster.mesh_count(); ++mesh) {
    trees.push_back(kd_tree_bytes(static_cast<const KdTree&>(caster.structure(mesh))));
  }
  std::vector<std::byte> bytes;
  for (const char c : magic) append(bytes, static_cast<std::uint8_t>(c));
  append(bytes, version);
  append(bytes, caster.mesh_count());
  for (const auto& tree : trees) append(bytes, std::uint64_t{tree.size()});
  for (const auto& tree : trees) bytes.insert(bytes.end(), tree.begin(), tree.end());
  return bytes;
}

std::unique_ptr<SceneCaster> kd_trees_from_bytes(std::span<const std::byte> bytes, const Scene& scene,
                                                 const std::string& where) {
  const std::uint32_t count = check_header(bytes, where);
  if (count != scene.meshes().size()) {
    refuse("has kd-trees of " + std::to_string(count) + " meshes; the scene has " +
               std::to_string(scene.meshes().size()),
           where);
  }
  std::size_t next = header_size + std::size_t{count} * size_size;
  if (bytes.size() < next) refuse("ends within its header", where);
  std::vector<std::unique_ptr<Accelerator>> trees;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto size = word_at<std::uint64_t>(bytes, header_size + i * size_size);
    if (size > bytes.size() - next) refuse("ends within the tree of mesh " + std::to_string(i), where);
    const Mesh& mesh = scene.meshes()[i];
    trees.push_back(kd_tree_from_bytes(bytes.subspan(next, static_cast<std::size_t>(size)),
                                       {mesh.positions.span(), mesh.triangles.span()},
                                       where + ", mesh " + std::to_string(i)));
    next += static_cast<std::size_t>(size);
  }
  if (next != bytes.size()) refuse("goes on after its last tree", where);
  return std::make_unique<SceneCaster>(scene, AcceleratorKind::kd_tree, std::move(trees));
}

void save_kd_trees(const std::filesystem::path& path, const SceneCaster& caster) {
  write_file(path, kd_trees_bytes(caster));
}

std::unique_ptr<SceneCaster> load_kd_trees(const std::filesystem::path& path, const Scene& scene) {
  return kd_trees_from_bytes(read_file(path), scene, input_name(path));
}

}  // namespace velum
