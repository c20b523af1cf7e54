#include "load_textures.hpp"

#include <filesystem>
#include <map>
#include <memory>

#include "../base/error.hpp"
#include "../image/file_bytes.hpp"
#include "../image/picture_file.hpp"

namespace velum {
namespace {

/// Textures by file, read once; null where that failed.
class TextureFiles {
 public:
  std::shared_ptr<const Texture> texture(const std::string& named) {
    const std::filesystem::path path = std::filesystem::path(named).lexically_normal();
    const auto [place, is_new] = textures_.try_emplace(path.generic_string());
    if (is_new) place->second = read(path);
    return place->second;
  }

  void tell(std::vector<std::string>& notes) const {
    if (left_out_ == 0) return;
    notes.push_back(std::to_string(left_out_) + (left_out_ == 1 ? " texture is" : " textures are") +
                    " left out, the first because of " + first_reason_);
  }

 private:
  std::shared_ptr<const Texture> read(const std::filesystem::path& path) {
    try {
      return std::make_shared<const Texture>(picture(path));
    } catch (const Error& error) {
      if (left_out_++ == 0) first_reason_ = error.what();
      return nullptr;
    }
  }

  Image<Rgba8> picture(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored))
      throw Error(ErrorKind::read, "there is no such picture", path.string());
    Image<Rgba8> image = decode_picture(read_file(path), path.string(), texels_left_);
    texels_left_ -= static_cast<std::uint64_t>(image.width()) * static_cast<std::uint64_t>(image.height());
    return image;
  }

  std::map<std::string, std::shared_ptr<const Texture>> textures_;
  std::uint64_t texels_left_ = max_scene_texels;
  std::size_t left_out_ = 0;
  std::string first_reason_;
};

}  // namespace

void load_textures(Scene& scene) {
  TextureFiles files;
  for (std::uint32_t i = 0; i < scene.materials().size(); ++i) {
    if (scene.materials()[i].base_colour_texture.empty() || scene.materials()[i].texture) continue;
    Material material = scene.materials()[i];
    material.texture = files.texture(material.base_colour_texture);
    if (material.texture) scene.set_material(i, std::move(material));
  }
  files.tell(scene.notes);
}

}  // namespace velum
