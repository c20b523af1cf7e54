#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace velum {

/// Writes bytes whole or not at all: into a temporary file in the same folder, then renamed. "-" is standard
/// output. An existing file keeps its permissions; a link is followed; what is no regular file (a device, a
/// pipe) is written to in place. A folder is refused. @throws Error (write) with the path and the system's
/// reason
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Reads a whole file; "-" is standard input. @throws Error (read) with the path and the system's reason;
/// (limit) for a file, or a pipe that does not end, of more bytes than `most` (0: half of the machine's
/// memory)
std::vector<std::byte> read_file(const std::filesystem::path& path, std::uint64_t most = 0);

/// How messages call a file that is read: its path, or "standard input" for "-".
std::string input_name(const std::filesystem::path& path);

}  // namespace velum
