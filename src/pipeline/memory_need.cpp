#include "memory_need.hpp"

#include <algorithm>
#include <limits>

#include "../base/error.hpp"
#include "../base/machine.hpp"
#include "picture.hpp"
#include "shade_stage.hpp"

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

std::uint64_t buffer_bytes(const Scene& scene, const RenderSettings& settings, const Rect& rect) {
  const std::uint64_t one_visibility = bytes_of_images<float, std::uint32_t>(rect);
  const std::uint64_t visibility = settings.wireframe ? 2 * one_visibility : one_visibility;
  if (!may_be_translucent(scene, settings)) return visibility;
  // Colour and mark of translucent pixels; the counts of fragments; per pixel the end of a list, and open.
  const std::uint64_t gathered = bytes_of_images<glm::vec4, std::uint8_t, std::uint32_t>(rect);
  const auto pixels = static_cast<std::uint64_t>(rect.width) * static_cast<std::uint64_t>(rect.height);
  return visibility + gathered + pixels * (sizeof(std::uint32_t) + sizeof(LayerBuffers::OpenPixel));
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
