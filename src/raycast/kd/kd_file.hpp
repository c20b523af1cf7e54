#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "kd_tree.hpp"

namespace velum {

/// Writes a kd-tree to a file, to be read again instead of being built. The file has no triangles, only a
/// fingerprint of them. "-" is standard output. @throws Error (write)
///
/// The file is little-endian. A header of 80 bytes: "velum-kd"; then as 32-bit words the version (1), the
/// numbers of nodes, ids and triangles; 64-bit fingerprint of the triangles; pad (double); the root's cell
/// (6 floats); the number of reaches; a word 0; 64-bit checksum of all the rest. Then nodes, ids and reaches,
/// as in KdArrays.
void save_kd_tree(const std::filesystem::path& path, const KdTree& tree);

/// Reads a kd-tree over these triangles. "-" is standard input.
///
/// A file that is not whole and sound is refused: another version, another length than its header says, a
/// checksum that does not match, other triangles, or arrays that are no tree (see fault_in). So whatever the
/// bytes are, no ray through a loaded tree runs on for ever or reads what is not there. No more memory is
/// taken than the file has bytes, twice, before it is found good. Someone who forges checksum and fingerprint
/// can make rays miss triangles, no more.
/// @param walk  ropes: as for KdTree's constructor, the tree must have been built for them
/// @throws Error (read), with the file and what to do
std::unique_ptr<KdTree> load_kd_tree(const std::filesystem::path& path, const TriangleSet& triangles,
                                     KdWalk walk = KdWalk::stack);

/// The same in memory. @param where  names the bytes in messages
std::vector<std::byte> kd_tree_bytes(const KdTree& tree);
std::unique_ptr<KdTree> kd_tree_from_bytes(std::span<const std::byte> bytes, const TriangleSet& triangles,
                                           const std::string& where, KdWalk walk = KdWalk::stack);

/// Puts the checksum right that bytes of a file should have; for tests, which would otherwise try the
/// checksum alone. Does nothing for bytes that are shorter than a header.
void mend_kd_checksum(std::span<std::byte> bytes);

}  // namespace velum
