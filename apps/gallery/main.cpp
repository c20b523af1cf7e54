// The program `velum-gallery`: real files and built-in shapes under every projection, as a page of pictures.
#include <CLI/CLI.hpp>
#include <iostream>
#include <velum/velum.hpp>

#include "page.hpp"
#include "pictures.hpp"
#include "sheet.hpp"
#include "subjects.hpp"

namespace {

using namespace velum_gallery;
namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw velum::Error(velum::ErrorKind::write, error.message(), folder.string());
}

const Subject& subject_for_shadings(const std::vector<Subject>& subjects) {
  for (const Subject& subject : subjects) {
    if (subject.stem == "spider") return subject;
  }
  return subjects.front();
}

void make_gallery(const fs::path& folder, const std::vector<Subject>& subjects) {
  make_folder(folder);
  velum::Renderer renderer;
  std::vector<Section> sections;
  std::size_t count = 0;
  for (const velum::ProjectionEntry& entry : velum::projection_catalogue()) {
    sections.push_back(render_projection(renderer, entry, subjects, folder));
    count += sections.back().shots.size();
    std::cout << entry.name << ' ' << std::flush;
  }
  sections.push_back(render_shadings(renderer, subject_for_shadings(subjects), folder));
  count += sections.back().shots.size();

  const std::string html = page_html(sections);
  velum::write_file(folder / "index.html", std::as_bytes(std::span(html)));
  std::cout << '\n' << count << " pictures; open " << fs::absolute(folder / "index.html").string() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("Renders real files and built-in shapes under every projection into a page of pictures.",
                   "velum-gallery");
  std::string folder;
  std::string sheet;
  program.add_option("--out", folder, "The folder for index.html and its pictures; made if absent")
      ->type_name("DIR");
  program.add_option("--sheet", sheet, "One small picture of several projections, as in the README")
      ->type_name("FILE.png");
  program.require_option(1, 2);
  try {
    program.parse(argc, argv);
    std::vector<std::string> skipped;
    const std::vector<Subject> subjects = load_subjects(skipped);
    for (const std::string& input : skipped) std::cout << "not installed, left out: " << input << '\n';
    if (!sheet.empty()) write_sheet(sheet, subjects);
    if (!folder.empty()) make_gallery(folder, subjects);
    return 0;
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code() == 0 ? program.exit(error) : (program.exit(error), 2);
  } catch (const velum::Error& error) {
    std::cerr << "velum-gallery: " << error.what() << '\n';
    return error.kind() == velum::ErrorKind::read ? 3 : error.kind() == velum::ErrorKind::write ? 4 : 2;
  }
}
