#pragma once

#include <filesystem>
#include <string>

namespace velum_bench {

/// Writes a text file, with the folders it stands in. @throws velum::Error (write)
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace velum_bench
