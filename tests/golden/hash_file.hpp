#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace golden {

/// The lines of hashes.txt: a picture's name → its fingerprint. @throws velum::Error (read)
std::map<std::string, std::string> read_hashes(const std::filesystem::path& path);

/// "depth, triangles": the buffers whose hashes differ between two fingerprints; all of them where one is
/// empty.
std::string differing_buffers(const std::string& expected, const std::string& actual);

}  // namespace golden
