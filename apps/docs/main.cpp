// The program `velum-docs`: writes the numbers and pictures of docs/pipeline.md, so that they never lag
// behind.
#include <CLI/CLI.hpp>
#include <iostream>
#include <velum/velum.hpp>

#include "blocks.hpp"

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  const std::vector<std::byte> bytes = velum::read_file(path);
  return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

/// Only what differs is touched.
void write_if_other(const fs::path& path, std::span<const std::byte> bytes) {
  if (fs::exists(path)) {
    const std::vector<std::byte> old = velum::read_file(path);
    if (std::equal(old.begin(), old.end(), bytes.begin(), bytes.end())) return;
  }
  velum::write_file(path, bytes);
  std::cout << path.string() << '\n';
}

void write_docs(const fs::path& page, const fs::path& pictures) {
  const std::string before = text_of(page);
  const velum_docs::Docs docs = velum_docs::make_docs();
  const std::string after = velum_docs::filled_in(before, docs.blocks, page.string());
  fs::create_directories(pictures);
  for (const auto& [name, picture] : docs.pictures)
    write_if_other(pictures / name, velum::encode_png(picture.view()));
  write_if_other(page, std::as_bytes(std::span(after)));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("Fills in the made parts of a page and writes its pictures.", "velum-docs");
  std::string page, pictures;
  program.add_option("--page", page, "The page, changed in place")->required()->type_name("FILE.md");
  program.add_option("--pictures", pictures, "The folder for its pictures; made if absent")
      ->required()
      ->type_name("DIR");
  try {
    program.parse(argc, argv);
    write_docs(page, pictures);
    return 0;
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code() == 0 ? program.exit(error) : (program.exit(error), 2);
  } catch (const velum::Error& error) {
    std::cerr << "velum-docs: " << error.what() << '\n';
    return error.kind() == velum::ErrorKind::read ? 3 : error.kind() == velum::ErrorKind::write ? 4 : 2;
  }
}
