// libFuzzer's target for the kd-tree file: any bytes, as they are and with their checksum put right.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "image/file_bytes.hpp"
#include "raycast/kd_file_trial.hpp"

namespace {

const KdFileTrial& trial() {
  static const KdFileTrial instance;
  return instance;
}

}  // namespace

/// A corpus folder that is empty gets sound files to start from: without them nothing is found for long.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  const std::filesystem::path folder = (*argv)[*argc - 1];
  if (!std::filesystem::is_directory(folder) || !std::filesystem::is_empty(folder)) return 0;
  velum::write_file(folder / "ropes.kd", trial().sound_file(velum::KdWalk::ropes));
  velum::write_file(folder / "stack.kd", trial().sound_file(velum::KdWalk::stack, velum::KdCut::referenced));
  velum::write_file(folder / "empty.kd", kd_tree_bytes(velum::KdTree({})));
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto* first = reinterpret_cast<const std::byte*>(data);
  std::vector<std::byte> bytes(first, first + size);
  trial().run(bytes);
  velum::mend_kd_checksum(bytes);
  trial().run(bytes);
  return 0;
}
