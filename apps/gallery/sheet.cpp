#include "sheet.hpp"

namespace velum_gallery {
namespace {

using namespace velum;

struct Tile {
  const char* stem;
  const char* projection;
};

constexpr int columns = 4;
constexpr int rows = 2;
constexpr int tile_width = 240;
constexpr int tile_height = 200;
constexpr int fine = 3;  ///< the sheet is rendered this many times larger, then averaged
constexpr Rgba8 ground{246, 244, 239, 255};

constexpr Tile tiles[rows * columns] = {
    {"letter-f", "cabinet"},     {"letter-f", "isometric"}, {"house", "two-point"},
    {"bunny", "perspective"},    {"house", "military"},     {"house", "natural-oblique"},
    {"letter-f", "three-point"}, {"bunny", "dimetric"},
};

const Subject* find_subject(const std::vector<Subject>& subjects, const std::string& stem) {
  for (const Subject& subject : subjects) {
    if (subject.stem == stem) return &subject;
  }
  return nullptr;
}

/// Every fine·fine pixels become one: their mean in linear light.
Image<Rgba8> averaged(const Image<Rgba8>& large) {
  Image<Rgba8> small(large.width() / fine, large.height() / fine);
  for (int y = 0; y < small.height(); ++y) {
    for (int x = 0; x < small.width(); ++x) {
      glm::vec4 sum(0.0f);
      for (int i = 0; i < fine * fine; ++i) {
        sum += linear_from_srgb(large.at(fine * x + i % fine, fine * y + i / fine));
      }
      small.at(x, y) = srgb_from_linear(sum / static_cast<float>(fine * fine));
    }
  }
  return small;
}

}  // namespace

void write_sheet(const std::filesystem::path& path, const std::vector<Subject>& subjects) {
  constexpr int width = fine * tile_width;
  constexpr int height = fine * tile_height;
  Image<Rgba8> sheet(columns * width, rows * height, ground);
  Renderer renderer;
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.background = ground;
  FrameOptions framing;
  framing.aspect = static_cast<double>(tile_width) / tile_height;
  framing.margin = 0.08;
  for (int i = 0; i < rows * columns; ++i) {
    const Subject* subject = find_subject(subjects, tiles[i].stem);
    if (subject == nullptr) continue;
    const Camera camera = frame(subject->scene.points(), parse_projection(tiles[i].projection), framing);
    // The tile is a window on the sheet's own memory.
    PictureTarget target;
    target.colour = {sheet.row(i / columns * height) + i % columns * width, width, height, sheet.stride()};
    renderer.render_into(subject->scene, camera, settings, target);
  }
  write_png(path, averaged(sheet).view());
}

}  // namespace velum_gallery
