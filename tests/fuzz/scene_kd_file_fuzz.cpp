// libFuzzer's target for the file with the kd-trees of all meshes of a scene: any bytes, as they are, and
// with the checksum of each tree put right. Reading ends in an Error (read) or in trees in which every ray
// finds an end.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "base/error.hpp"
#include "image/file_bytes.hpp"
#include "raycast/kd/kd_file.hpp"
#include "raycast/random_scenes.hpp"
#include "raycast/scene_kd_file.hpp"

namespace velum {

/// Instead of the library's, so that the other structures need not be built in.
std::unique_ptr<Accelerator> build_accelerator(AcceleratorKind, const TriangleSet& triangles, Isa) {
  return std::make_unique<KdTree>(triangles);
}

}  // namespace velum

namespace {

constexpr std::size_t header_size = 16, size_size = 8;

velum::Mesh mesh_of(Random& random, int count) {
  RandomTriangles triangles;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 a(random_point(random));
    triangles.add(a, a + glm::vec3(random_point(random, 0.3)), a + glm::vec3(random_point(random, 0.3)));
  }
  velum::Mesh mesh;
  mesh.positions = triangles.positions;
  mesh.triangles = triangles.triangles;
  return mesh;
}

/// Three meshes, one without triangles, and four instances.
class SceneTrial {
 public:
  SceneTrial() {
    Random random{77};
    const std::uint32_t many = scene_.add_mesh(mesh_of(random, 30));
    const std::uint32_t few = scene_.add_mesh(mesh_of(random, 3));
    scene_.add_mesh(velum::Mesh{});
    for (int i = 0; i < 4; ++i) {
      glm::dmat4 placement(1.0);
      placement[3] = glm::dvec4(random_point(random), 1.0);
      scene_.add_instance({i % 2 == 0 ? many : few, 0, placement, ""});
    }
    for (int i = 0; i < 24; ++i) rays_.push_back(random_ray(random));
  }

  std::vector<std::byte> sound_file() const {
    return kd_trees_bytes(velum::SceneCaster(scene_, velum::AcceleratorKind::kd_tree));
  }

  void run(std::span<const std::byte> bytes) const {
    try {
      cast(*kd_trees_from_bytes(bytes, scene_, "trial"));
    } catch (const velum::Error& error) {
      if (error.kind() != velum::ErrorKind::read) throw std::logic_error("another kind of error");
    }
  }

 private:
  void cast(const velum::SceneCaster& caster) const {
    for (const velum::Ray& ray : rays_) {
      velum::CastCounters counters;
      std::vector<velum::SceneHit> all;
      const bool is_hit = caster.first_hit(ray, {}, counters).is_hit();
      if (caster.is_blocked(ray, {}, counters) != is_hit) throw std::logic_error("blocked, but not hit");
      caster.all_hits(ray, {}, counters, all);
    }
  }

  velum::Scene scene_;
  std::vector<velum::Ray> rays_;
};

const SceneTrial& trial() {
  static const SceneTrial instance;
  return instance;
}

std::uint64_t word_at(std::span<const std::byte> bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value |= std::to_integer<std::uint64_t>(bytes[at + i]) << 8 * i;
  return value;
}

/// Each tree's checksum, as far as there are trees where the header says.
void mend_checksums(std::span<std::byte> bytes) {
  if (bytes.size() < header_size) return;
  const std::uint64_t count = word_at(bytes, 12, 4);
  if (count > (bytes.size() - header_size) / size_size) return;
  std::size_t next = header_size + static_cast<std::size_t>(count) * size_size;
  for (std::size_t i = 0; i < count; ++i) {
    const auto size = static_cast<std::size_t>(
        std::min<std::uint64_t>(word_at(bytes, header_size + i * size_size, size_size), bytes.size() - next));
    velum::mend_kd_checksum(bytes.subspan(next, size));
    next += size;
  }
}

}  // namespace

/// A corpus folder that is empty gets a sound file to start from.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  const std::filesystem::path folder = (*argv)[*argc - 1];
  if (std::filesystem::is_directory(folder) && std::filesystem::is_empty(folder))
    velum::write_file(folder / "scene.kd", trial().sound_file());
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto* first = reinterpret_cast<const std::byte*>(data);
  std::vector<std::byte> bytes(first, first + size);
  trial().run(bytes);
  mend_checksums(bytes);
  trial().run(bytes);
  return 0;
}
