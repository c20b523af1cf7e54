// The small picture with 1, 4 and 16 samples per pixel, and where the samples lie.
#include <velum/visibility/sample_positions.hpp>

#include "blocks.hpp"
#include "paint.hpp"

namespace velum_docs {
namespace {

using namespace velum;

constexpr int scale = 10;  ///< a pixel of the small picture on the page
constexpr int caption = 24;
constexpr int pixel_side = 128;  ///< of the one pixel that shows its samples

/// One pixel with a dot for each sample; the lines are where the picture's sixteenths lie.
void draw_pattern(Canvas& canvas, int samples, int left, int top) {
  constexpr int step = pixel_side / 16;
  for (int i = 0; i <= 16; ++i) {
    const Rgba8 colour = i % 16 == 0 ? ink : grid_colour;
    canvas.rectangle(left + i * step, top, 1, pixel_side + 1, colour);
    canvas.rectangle(left, top + i * step, pixel_side + 1, 1, colour);
  }
  const glm::dvec2 centre(left + 0.5 * pixel_side, top + 0.5 * pixel_side);
  for (const SamplePosition& sample : sample_positions(samples))
    canvas.disc(centre + glm::dvec2(sample.x, sample.y) * (pixel_side / 256.0), 3.5, red);
}

Image<Rgba8> panel(const Subject& subject, int samples) {
  RenderSettings settings = subject.settings;
  settings.samples = samples;
  const int width = settings.width * scale, height = settings.height * scale;
  Canvas canvas(width, caption + height + 10 + pixel_side + 2, paper);
  canvas.text({2, 5}, std::to_string(samples) + (samples == 1 ? " sample" : " samples"), 2, ink);
  paint_image(canvas, render(subject.scene, subject.camera, settings).colour, 0, caption, scale);
  draw_pattern(canvas, samples, (width - pixel_side) / 2, caption + height + 10);
  return canvas.picture();
}

}  // namespace

Image<Rgba8> draw_samples(const Subject& subject) {
  const Image<Rgba8> panels[] = {panel(subject, 1), panel(subject, 4), panel(subject, 16)};
  return side_by_side(panels, 6);
}

}  // namespace velum_docs
