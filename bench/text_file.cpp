#include "text_file.hpp"

#include <fstream>
#include <velum/velum.hpp>

namespace velum_bench {

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::error_code ignored;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
  std::ofstream stream(file, std::ios::binary);
  stream << text << std::flush;
  if (!stream)
    throw velum::Error(velum::ErrorKind::write, "the file cannot be written", file.string(),
                       "choose another folder with --out");
}

}  // namespace velum_bench
