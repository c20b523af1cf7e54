#include "blocks.hpp"

namespace velum_docs {
namespace {

/// The same numbers from the program.
std::string commands_block(const Subject& subject) {
  const std::string triangle = std::to_string(subject.triangle.primitive);
  const std::string pixel = std::to_string(subject.pixel.x) + "," + std::to_string(subject.pixel.y);
  return "```sh\nvelum render " + subject.options +
         " --visibility scanline --clip exact -o small.png\nvelum clip-trace " + subject.options +
         " --triangle " + triangle + " -o clip.png\nvelum pixel " + subject.options + " --clip exact --at " +
         pixel + " -o pixel.png\n```\n";
}

}  // namespace

Docs make_docs() {
  const Subject subject = make_subject();
  Docs docs;
  docs.blocks["commands"] = commands_block(subject);
  docs.pictures["scene.png"] = draw_scene(subject);
  docs.pictures["spaces.png"] = draw_spaces(subject);
  docs.pictures["clipping.png"] = velum::draw_clipping(subject.clip, 360);
  docs.pictures["conventions.png"] = draw_conventions(subject);
  docs.pictures["spans.png"] = draw_spans(subject);
  docs.pictures["samples.png"] = draw_samples(subject);
  docs.pictures["acne.png"] = draw_acne();
  docs.pictures["pixel.png"] =
      velum::draw_pixel(subject.pixel, subject.scene, subject.camera, subject.settings, {5, 40});
  add_stage_blocks(subject, docs);
  add_raster_blocks(subject, docs);
  add_interpolation(subject, docs);
  add_depth_blocks(docs);
  return docs;
}

}  // namespace velum_docs
