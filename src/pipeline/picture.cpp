#include "picture.hpp"

#include "../image/visibility_buffer.hpp"

namespace velum {

void Picture::resize(int width, int height) {
  colour.resize(width, height);
  depth.resize(width, height);
  metric_depth.resize(width, height);
  normal.resize(width, height);
  object_id.resize(width, height);
  triangle_id.resize(width, height);
}

double Picture::coverage() const {
  if (triangle_id.is_empty()) return 0.0;
  std::uint64_t covered = 0;
  for (int y = 0; y < triangle_id.height(); ++y) {
    for (int x = 0; x < triangle_id.width(); ++x) covered += triangle_id.at(x, y) != no_primitive;
  }
  const double pixels = static_cast<double>(triangle_id.width()) * triangle_id.height();
  return static_cast<double>(covered) / pixels;
}

Rect Picture::bounding_box() const {
  int left = triangle_id.width();
  int top = triangle_id.height();
  int right = 0;
  int bottom = 0;
  for (int y = 0; y < triangle_id.height(); ++y) {
    for (int x = 0; x < triangle_id.width(); ++x) {
      if (triangle_id.at(x, y) == no_primitive) continue;
      left = std::min(left, x);
      right = std::max(right, x + 1);
      top = std::min(top, y);
      bottom = std::max(bottom, y + 1);
    }
  }
  return right <= left ? Rect{} : Rect{left, top, right - left, bottom - top};
}

Image<float> reversed_depth_of(const Picture& picture) {
  Image<float> reversed(picture.depth.width(), picture.depth.height());
  for (int y = 0; y < reversed.height(); ++y) {
    for (int x = 0; x < reversed.width(); ++x) reversed.at(x, y) = 1.0f - picture.depth.at(x, y);
  }
  return reversed;
}

namespace {

template <typename T>
ImageView<T> rows_of(const ImageView<T>& view, int top, int count) {
  return view.data == nullptr ? ImageView<T>{} : ImageView<T>{view.row(top), view.width, count, view.stride};
}

}  // namespace

PictureTarget PictureTarget::rows(int top, int count) const {
  return {rows_of(colour, top, count), rows_of(depth, top, count),     rows_of(metric_depth, top, count),
          rows_of(normal, top, count), rows_of(object_id, top, count), rows_of(triangle_id, top, count)};
}

}  // namespace velum
