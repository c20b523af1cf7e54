#pragma once

#include <filesystem>

#include "page.hpp"
#include "subject.hpp"

namespace velum_docs {

/// Everything that ./run docs writes: the page's made parts, and pictures by file name.
struct Docs {
  Blocks blocks;
  std::map<std::string, velum::Image<velum::Rgba8>> pictures;
};

Docs make_docs();

// Each file adds its own parts.
void add_stage_blocks(const Subject& subject, Docs& docs);
void add_raster_blocks(const Subject& subject, Docs& docs);
void add_interpolation(const Subject& subject, Docs& docs);
void add_depth_blocks(Docs& docs);

// Pictures.
velum::Image<velum::Rgba8> draw_scene(const Subject& subject);
velum::Image<velum::Rgba8> draw_spaces(const Subject& subject);
velum::Image<velum::Rgba8> draw_conventions(const Subject& subject);
velum::Image<velum::Rgba8> draw_spans(const Subject& subject);
velum::Image<velum::Rgba8> draw_samples(const Subject& subject);
velum::Image<velum::Rgba8> draw_acne();

}  // namespace velum_docs
