#pragma once

#include <vector>

#include "../base/rect.hpp"
#include "../image/image.hpp"
#include "depth_plane.hpp"

namespace velum {

/// The answer to "is everything in this rectangle strictly nearer than that?".
struct PyramidAnswer {
  bool is_hidden = false;
  int level = 0;  ///< the finest level that had to be looked at; of hidden rectangles, where the last part of
                  ///< it was rejected
};

/// The z-pyramid (Greene, Kass & Miller 1993, "Hierarchical Z-Buffer Visibility"): level 0 is the z-buffer,
/// which stays where it is; a value of every further level is the farthest of four of the level below. Depths
/// are reversed (1 near, 0 far), so "farthest of four" is the smallest r. Sizes are halved and rounded up;
/// children that are missing at the right and lower edge do not count. The last level is one value.
///
/// Depths only ever come nearer while a picture is drawn, so a pyramid that is not up to date is too far, and
/// what it hides is hidden.
class ZPyramid {
 public:
  /// Stands over a z-buffer, given as reversed depths; all further levels are 0, the background's.
  /// @param z_buffer  must live as long as the pyramid is used, width and height ≥ 1
  void begin(const ImageView<const float>& z_buffer);

  /// begin() and update() of everything.
  void build(const ImageView<const float>& z_buffer);

  /// Brings all levels up to date after pixels of `rect` (within the z-buffer) have changed.
  void update(const Rect& rect) { update(rect, 1, levels() - 1); }

  /// The same for levels first … last only, those below being up to date. Calls at the same time must not
  /// share a cell: with last ≤ n, rectangles from a grid of 2ⁿ pixels do not.
  /// @pre 1 ≤ first
  void update(const Rect& rect, int first, int last);

  /// How many there are, level 0 included; 0 before begin().
  int levels() const { return static_cast<int>(above_.size()) + (base_.data == nullptr ? 0 : 1); }
  /// @pre 0 ≤ i < levels()
  ImageView<const float> level(int i) const {
    return i == 0 ? base_ : above_[static_cast<std::size_t>(i) - 1].view();
  }

  /// Whether all pixels of the rectangle are strictly nearer than `bound`: then nothing there that is at
  /// `bound` or farther is seen. Descends from the coarsest level that can tell, quadrant by quadrant, and
  /// stops at the first pixel, or at the first cell wholly inside the rectangle, that says no. A rectangle
  /// without pixels of the z-buffer is hidden.
  PyramidAnswer is_hidden(const Rect& rect, float bound) const;

  /// The same for a surface, whose nearest depth is known in every quadrant: it stands at a corner.
  /// @param plane       reversed depth at pixels of the whole picture
  /// @param left, top   where the z-buffer's first pixel lies in the picture
  PyramidAnswer is_hidden(const Rect& rect, const DepthPlane& plane, int left, int top) const;

 private:
  template <typename Bound>
  class Descent;
  template <typename Bound>
  PyramidAnswer descend(const Rect& rect, const Bound& bound) const;
  template <typename Bound>
  PyramidAnswer below(const Rect& rect, const Bound& bound, int first) const;
  void find_coarsest();
  float value(int level, int x, int y) const {
    return level == 0 ? base_.at(x, y) : above_[static_cast<std::size_t>(level) - 1].at(x, y);
  }

  ImageView<const float> base_;
  std::vector<Image<float>> above_;  // level 1 and further
  int coarsest_ = 0;                 // the coarsest level that is not the background's everywhere
};

}  // namespace velum
