#include "memory_need.hpp"

#include <algorithm>
#include <limits>

#include "../base/error.hpp"
#include "../base/machine.hpp"
#include "../visibility/tile_buffer.hpp"
#include "../visibility/tile_grid.hpp"
#include "picture.hpp"
#include "sample_stage.hpp"
#include "shade_stage.hpp"
#include "supersample_stage.hpp"
#include "tile_stage.hpp"

namespace velum {
namespace {

std::string mebibytes(std::uint64_t bytes) {
  return std::to_string((bytes + 1048575) / 1048576) + " MiB";
}

template <typename... T>
std::uint64_t bytes_of_images(const Rect& rect) {
  return (Image<T>::bytes_for(rect.width, rect.height) + ...);
}

bool is_opaque(const Material& material) {
  return material.alpha >= 1.0f && (material.texture == nullptr || material.texture->is_opaque());
}

bool is_opaque(const Mesh& mesh) {
  return std::all_of(mesh.colours.begin(), mesh.colours.end(),
                     [](const glm::vec4& colour) { return colour.w >= 1.0f; });
}

/// Whether a shading shows the material's opacity; the debug views are opaque.
bool shows_opacity(Shading shading) {
  return shading == Shading::flat || shading == Shading::gouraud || shading == Shading::phong;
}

}  // namespace

bool may_be_translucent(const Scene& scene, const RenderSettings& settings) {
  if (settings.has_custom_shader()) return true;
  if (!shows_opacity(settings.shading)) return false;
  const auto opaque = [](const auto& thing) { return is_opaque(thing); };
  return !std::all_of(scene.materials().begin(), scene.materials().end(), opaque) ||
         !std::all_of(scene.meshes().begin(), scene.meshes().end(), opaque);
}

std::uint64_t picture_bytes(const Rect& rect) {
  return bytes_of_images<Rgba8, float, float, glm::vec3, std::uint32_t, std::uint32_t>(rect);
}

namespace {

/// Beyond this the picture is made in bands, each of which goes through the scene anew.
constexpr std::uint64_t most_sample_bytes = std::uint64_t{1} << 28;

/// Per pixel: what each sample sees, and, where something may be translucent, the groups of its first layers;
/// marks of the wireframe and of open pixels.
std::uint64_t sample_bytes_per_pixel(const Scene& scene, const RenderSettings& settings) {
  if (settings.samples == 1 || !is_sample_count(settings.samples)) return 0;
  const std::uint64_t of_sample = may_be_translucent(scene, settings) ? 8 + sizeof(SampleGroup) : 8;
  const std::uint64_t marks = sizeof(MixedPixel) + 2 * sizeof(std::uint32_t);
  return static_cast<std::uint64_t>(settings.samples) * of_sample + marks;
}

}  // namespace

int sample_band_height(const Scene& scene, const RenderSettings& settings, const Rect& rect) {
  const std::uint64_t of_row =
      sample_bytes_per_pixel(scene, settings) * static_cast<std::uint64_t>(rect.width);
  if (of_row * static_cast<std::uint64_t>(rect.height) <= most_sample_bytes) return rect.height;
  const auto rows = static_cast<int>(most_sample_bytes / of_row);
  return rows <= tile_size ? std::max(rows, 1) : rows / tile_size * tile_size;
}

namespace {

/// All tiles at once, and the z-pyramid above the z-buffer.
std::uint64_t bytes_of_hierarchy(const RenderSettings& settings, const Rect& rect) {
  if (settings.visibility != VisibilityMethod::hierarchical) return 0;
  const auto tiles = static_cast<std::uint64_t>(TileGrid(rect).count());
  return tiles * (sizeof(TileBuffer) + tile_size * tile_size * sizeof(float) / 2);
}

std::uint64_t bytes_of_bands(const Scene& scene, const RenderSettings& settings, const Rect& whole) {
  const Rect rect{whole.left, whole.top, whole.width, sample_band_height(scene, settings, whole)};
  const std::uint64_t one_visibility = bytes_of_images<float, std::uint32_t>(rect);
  const bool has_tiles = settings.visibility == VisibilityMethod::zbuffer && settings.isa != Isa::reference;
  const std::uint64_t visibility = (settings.wireframe ? 2 * one_visibility : one_visibility) +
                                   bytes_of_hierarchy(settings, rect) +
                                   (has_tiles ? tile_stage_bytes(scene) : 0);
  const auto pixels = static_cast<std::uint64_t>(rect.width) * static_cast<std::uint64_t>(rect.height);
  const std::uint64_t seen = visibility + pixels * sample_bytes_per_pixel(scene, settings);
  if (!may_be_translucent(scene, settings)) return seen;
  // Colour and mark of translucent pixels; the counts of fragments; per pixel the end of a list, and open.
  const std::uint64_t gathered = bytes_of_images<glm::vec4, std::uint8_t, std::uint32_t>(rect);
  return seen + gathered + pixels * (sizeof(std::uint32_t) + sizeof(LayerBuffers::OpenPixel));
}

/// A band of the larger picture in itself, and what it takes to render it.
std::uint64_t bytes_of_larger(const Scene& scene, const RenderSettings& settings, const Rect& rect) {
  const int margin = static_cast<int>(2.0 * radius_of(settings.supersample_filter)) * settings.supersample;
  const int width = rect.width * settings.supersample + margin;
  const int height = rect.height * settings.supersample + margin;
  const Rect band{0, 0, width, std::min(height, supersample_band_height(width))};
  return bytes_of_images<Rgba8>(band) + bytes_of_bands(scene, settings, band);
}

}  // namespace

std::uint64_t buffer_bytes(const Scene& scene, const RenderSettings& settings, const Rect& rect) {
  if (settings.supersample <= 1 || settings.supersample > most_supersampling)
    return bytes_of_bands(scene, settings, rect);
  RenderSettings plain = settings;
  plain.samples = 1;
  // One after the other in the same buffers.
  return std::max(bytes_of_bands(scene, plain, rect), bytes_of_larger(scene, settings, rect));
}

std::uint64_t memory_left(std::uint64_t bytes, const RenderSettings& settings) {
  const bool is_chosen = settings.memory_ceiling != 0;
  const std::uint64_t ceiling = is_chosen ? settings.memory_ceiling : physical_memory() / 2;
  if (ceiling == 0) return std::numeric_limits<std::uint64_t>::max();  // the system does not tell
  if (bytes <= ceiling) return ceiling - bytes;
  throw Error(ErrorKind::limit,
              "the picture and the buffers for it need " + mebibytes(bytes) + "; " +
                  (is_chosen ? "the memory ceiling" : "half of this machine's memory") + " is " +
                  mebibytes(ceiling),
              "size", "ask for a smaller picture, or for one part after the other (a crop)");
}

}  // namespace velum
