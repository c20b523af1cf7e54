#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "colour.hpp"
#include "image.hpp"

namespace velum {

/// A picture to be laid over surfaces: its texels in linear light, premultiplied with alpha so that what is
/// transparent does not bleed into what is not, and ever smaller versions of it (a mip pyramid, Williams
/// 1983, "Pyramidal Parametrics"). Immutable: many materials and threads may share one.
///
/// Level 0 is the picture; each next level has half the size, rounded down, at least 1; the last is one
/// texel. A texel of a level is the exact mean over the area it covers, also where a size is odd and it
/// covers parts of texels, so that every level has the mean of the picture.
class Texture {
 public:
  /// A pyramid in memory takes some 22 bytes a texel of the picture.
  /// @pre the picture is not empty
  explicit Texture(ImageView<const Rgba8> picture);

  /// Of level 0, in texels.
  int width() const { return levels_.front().width(); }
  int height() const { return levels_.front().height(); }
  int level_count() const { return static_cast<int>(levels_.size()); }
  /// Linear, premultiplied; row 0 is the top. @pre 0 ≤ index < level_count()
  const Image<glm::vec4>& level(int index) const { return levels_[static_cast<std::size_t>(index)]; }
  /// Whether every texel has alpha 1.
  bool is_opaque() const { return is_opaque_; }
  /// A hash of the picture: equal pictures have equal ones.
  std::uint64_t content_hash() const { return content_hash_; }

 private:
  std::vector<Image<glm::vec4>> levels_;
  std::uint64_t content_hash_ = 0;
  bool is_opaque_ = true;
};

}  // namespace velum
