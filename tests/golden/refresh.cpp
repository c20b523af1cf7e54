// velum_goldens PICTURES HASHES: makes the committed PNGs and hashes those of today, and touches only what
// differs. Prints what it wrote. Look at every picture it names before committing it.
#include <cstdio>
#include <filesystem>
#include <set>

#include "fingerprint.hpp"
#include "golden_file.hpp"
#include "scenes.hpp"

namespace {

using namespace golden;
namespace fs = std::filesystem;

void report_orphans(const fs::path& folder, const std::set<fs::path>& files) {
  if (!fs::exists(folder)) return;
  for (const auto& file : fs::directory_iterator(folder)) {
    if (files.count(file.path().filename()) == 0) {
      std::printf("%s is of no scene any more; delete it\n", file.path().c_str());
    }
  }
}

void refresh_all(const Places& places, const fs::path& hash_path) {
  std::string text;
  std::set<fs::path> files;
  const std::vector<GoldenScene> scenes = golden_scenes();
  for (const GoldenPicture& picture : golden_pictures(scenes)) {
    const velum::Picture rendered = picture.render(golden_modes().front());
    text += picture.name() + " " + fingerprint(rendered) + "\n";
    if (!picture.has_file()) continue;
    const fs::path file = file_name(picture.name());
    files.insert(file);
    if (refresh(picture.name(), rendered.colour, places)) {
      std::printf("wrote %s\n", (places.pictures / file).c_str());
    }
  }
  report_orphans(places.pictures, files);
  if (refresh_text(hash_path, text)) std::printf("wrote %s\n", hash_path.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: velum_goldens PICTURES HASHES\n");
    return 2;
  }
  try {
    refresh_all({argv[1], {}}, argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "velum_goldens: %s\n", error.what());
    return 1;
  }
}
