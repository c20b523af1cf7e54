// The part of SampleStage that looks behind translucent samples.

#include <algorithm>

#include "sample_stage.hpp"

namespace velum {
namespace {

/// Makes what nothing is to be sought behind the background.
void keep_open_samples(const Image<std::uint32_t>& open, int sample, const Rect& box,
                       VisibilityBuffer& seen) {
  for (int y = box.top; y < box.bottom(); ++y) {
    for (int x = box.left; x < box.right(); ++x) {
      if ((open.at(x, y) >> sample) & 1u) continue;
      seen.primitive.at(x, y) = no_primitive;
      seen.reversed_depth.at(x, y) = 0.0f;
    }
  }
}

}  // namespace

/// Layers behind the first, part by part of the buffer.
void SampleStage::shade_open_pixels(const LayerBuffers& layers, std::uint64_t most_fragments) {
  add_open_pixels(layers);
  const Rect box = begin_behind();
  if (box.is_empty()) return;
  for (const Rect& part : parts(box, most_fragments)) {
    gather_behind(part);
    for_each_run(true, [&](const Rect&, MixedRows& rows, PixelShader& shader) {
      for (const OpenPixel& pixel : rows.open) {
        if (part.contains(pixel.column, pixel.row)) shade_behind(pixel, layers, rows, shader);
      }
    });
  }
}

/// Those that are not mixed, but let something through.
void SampleStage::add_open_pixels(const LayerBuffers& layers) {
  for_each_run(false, [&](const Rect& run, MixedRows& rows, PixelShader&) {
    for (int y = run.top; y < run.bottom(); ++y) {
      for (int x = 0; x < run.width; ++x) {
        if (!layers.is_translucent.at(x, y)) continue;
        rows.open.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 0, 0});
      }
    }
  });
}

Rect SampleStage::in_picture(const Rect& part) const {
  return {part.left + input_.rect.left, part.top + input_.rect.top, part.width, part.height};
}

/// Counts the fragments behind all open samples. @return the box around their pixels, of the buffer
Rect SampleStage::begin_behind() {
  Rect box;
  for (const MixedRows& rows : buffers_.rows) {
    for (const OpenPixel& pixel : rows.open) box = united(box, {pixel.column, pixel.row, 1, 1});
  }
  if (box.is_empty()) return box;
  buffers_.open.resize(input_.rect.width, input_.rect.height);
  for (const MixedRows& rows : buffers_.rows) {
    for (const OpenPixel& pixel : rows.open) {
      std::uint32_t& open = buffers_.open.at(pixel.column, pixel.row);
      if (pixel.group_count == 0) open = all_samples(count_);
      for (const SampleGroup& group : rows.groups_of(pixel))
        open |= open_samples(pixel.column, pixel.row, group);
    }
  }
  buffers_.behind.resize(static_cast<std::size_t>(count_));
  for (int k = 0; k < count_; ++k) {
    VisibilityBuffer& seen = buffers_.seen[static_cast<std::size_t>(k)];
    FragmentLists& lists = buffers_.behind[static_cast<std::size_t>(k)];
    keep_open_samples(buffers_.open, k, box, seen);
    lists.begin_counting(seen, input_.rect, in_picture(box));
    draw_(k, in_picture(box), seen, &lists);
  }
  return box;
}

/// Runs of whole rows with at most so many fragments at all samples together, or a single row.
std::vector<Rect> SampleStage::parts(const Rect& box, std::uint64_t most_fragments) const {
  std::vector<Rect> parts;
  std::uint64_t gathered = 0;
  for (int y = box.top; y < box.bottom(); ++y) {
    std::uint64_t of_row = 0;
    for (const FragmentLists& lists : buffers_.behind) of_row += lists.count_of_row(y + input_.rect.top);
    if (parts.empty() || gathered + of_row > most_fragments) {
      parts.push_back({box.left, y, box.width, 0});
      gathered = 0;
    }
    ++parts.back().height;
    gathered += of_row;
  }
  return parts;
}

void SampleStage::gather_behind(const Rect& part) {
  for (int k = 0; k < count_; ++k) {
    FragmentLists& lists = buffers_.behind[static_cast<std::size_t>(k)];
    lists.begin_storing(in_picture(part));
    draw_(k, in_picture(part), buffers_.seen[static_cast<std::size_t>(k)], &lists);
    lists.sort();
  }
}

std::span<const std::uint64_t> SampleStage::behind(int sample, const OpenPixel& pixel) const {
  const auto list = buffers_.behind[static_cast<std::size_t>(sample)].at(pixel.column + input_.rect.left,
                                                                         pixel.row + input_.rect.top);
  return list.first(static_cast<std::size_t>(std::find(list.begin(), list.end(), 0u) - list.begin()));
}

/// All primitives of a pixel, in the order of their ids: those of the first layer have their colour, the
/// others the samples at which they are met behind it.
void SampleStage::collect_groups(const OpenPixel& pixel, MixedRows& rows) const {
  const std::uint32_t open = buffers_.open.at(pixel.column, pixel.row);
  std::vector<SampleGroup>& all = rows.all_groups;
  all.clear();
  for (const SampleGroup& group : rows.groups_of(pixel)) all.push_back(group);
  for (int k = 0; k < count_; ++k) {
    if (((open >> k) & 1u) == 0) continue;
    for (const std::uint64_t fragment : behind(k, pixel)) all.push_back({primitive_of(fragment), 1u << k});
  }
  // The first of equals is the one that is kept: shaded groups come before those that are not.
  std::stable_sort(all.begin(), all.end(),
                   [](const SampleGroup& a, const SampleGroup& b) { return a.primitive < b.primitive; });
  std::size_t last = 0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (all[i].primitive != all[last].primitive) {
      all[++last] = all[i];
    } else if (!all[last].is_shaded) {
      all[last].samples |= all[i].samples;
    }
  }
  if (!all.empty()) all.resize(last + 1);
}

void SampleStage::shade_behind(const OpenPixel& pixel, const LayerBuffers& whole, MixedRows& rows,
                               PixelShader& shader) const {
  collect_groups(pixel, rows);
  glm::vec4 samples[most_samples];
  if (pixel.group_count == 0) {
    std::fill(samples, samples + count_, whole.colour.at(pixel.column, pixel.row));
  } else {
    put_first_layer(pixel.column, pixel.row, rows.groups_of(pixel), samples);
  }
  const std::uint32_t open = buffers_.open.at(pixel.column, pixel.row);
  const std::uint64_t limit = input_.settings.layers;
  for (int k = 0; k < count_; ++k) {
    if (((open >> k) & 1u) == 0) continue;
    std::uint64_t layers = 1;
    for (const std::uint64_t fragment : behind(k, pixel)) {
      if (limit != 0 && layers >= limit) break;
      SampleGroup& group = *std::lower_bound(
          rows.all_groups.begin(), rows.all_groups.end(), primitive_of(fragment),
          [](const SampleGroup& g, std::uint32_t primitive) { return g.primitive < primitive; });
      if (!group.is_shaded) {
        shade_group(pixel.column, pixel.row, group, reversed_depth_of(fragment), shader);
        ++rows.shaded;
      }
      samples[k] = with_behind(samples[k], group.colour);
      ++layers;
      if (group.colour.w >= 1.0f) break;
    }
    rows.layers = std::max(rows.layers, layers);
  }
  write_colour(pixel.column, pixel.row, samples);
}

}  // namespace velum
