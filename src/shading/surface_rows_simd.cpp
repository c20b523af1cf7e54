#include "surface_rows.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/surface_rows_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's header is read anew for every target; it must follow the line above.
#include <hwy/highway.h>

#include "../base/simd_dispatch.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, 8>;
using Floats = hn::Rebind<float, Doubles>;
using Double = hn::Vec<Doubles>;
using Float = hn::Vec<Floats>;
using Mask = hn::Mask<Doubles>;
constexpr Doubles doubles;
constexpr Floats floats;

HWY_INLINE Double all(double value) {
  return hn::Set(doubles, value);
}
HWY_INLINE Float all(float value) {
  return hn::Set(floats, value);
}

template <typename V>
struct Vector3 {
  V x, y, z;
};

/// glm::dot(), in its order.
template <typename V>
HWY_INLINE V dot(const Vector3<V>& a, const Vector3<V>& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
template <typename V>
HWY_INLINE Vector3<V> over(const Vector3<V>& a, V divisor) {
  return {hn::Div(a.x, divisor), hn::Div(a.y, divisor), hn::Div(a.z, divisor)};
}
template <typename V, typename M>
HWY_INLINE Vector3<V> choose(M where, const Vector3<V>& a, const Vector3<V>& b) {
  return {hn::IfThenElse(where, a.x, b.x), hn::IfThenElse(where, a.y, b.y), hn::IfThenElse(where, a.z, b.z)};
}

/// The larger of two, b where they have no order, as std::max(a, b) has a.
HWY_INLINE Double larger(Double a, Double b) {
  return hn::IfThenElse(hn::Lt(a, b), b, a);
}

struct Weights {
  Vector3<Double> exact;
  Vector3<Double> clamped;
  Vector3<Double> edges;  ///< edge_values() of triangle_view.cpp
  Double sum;             ///< of them
};

/// barycentrics_at() in row y.
HWY_INLINE Weights weights_at(const TrianglePlanes& t, Double px, double py) {
  Double across[3];
  double down[3];
  for (int i = 0; i < 3; ++i) {
    across[i] = hn::Sub(all(t.pixel[i][0]), hn::Mul(px, all(t.pixel[i][2])));
    down[i] = t.pixel[i][1] - py * t.pixel[i][2];
  }
  const auto edge = [&](int a, int b) {
    return hn::Sub(hn::Mul(across[a], all(down[b])), hn::Mul(all(down[a]), across[b]));
  };
  const Vector3<Double> edges = {edge(1, 2), edge(2, 0), edge(0, 1)};
  const Double sum = hn::Add(hn::Add(edges.x, edges.y), edges.z);
  const Vector3<Double> exact = over(edges, sum);
  const Double zero = hn::Zero(doubles);
  const Mask is_sound =
      hn::And(hn::Gt(hn::Abs(sum), zero), hn::Le(dot(exact, exact), all(hwy::HighestValue<double>())));
  const auto positive = [&](Double v) { return hn::IfThenElse(hn::Lt(v, zero), zero, v); };
  const Vector3<Double> inside = {positive(exact.x), positive(exact.y), positive(exact.z)};
  const Double inside_sum = hn::Add(hn::Add(inside.x, inside.y), inside.z);
  const Vector3<Double> nearest = {all(t.nearest[0]), all(t.nearest[1]), all(t.nearest[2])};
  return {choose(is_sound, exact, nearest), choose(is_sound, over(inside, inside_sum), nearest), edges, sum};
}

/// interpolate() with the differences at hand.
HWY_INLINE Double interpolated(const double (&plane)[3], Double y, Double z) {
  return hn::Add(hn::Add(all(plane[0]), hn::Mul(all(plane[1]), y)), hn::Mul(all(plane[2]), z));
}
HWY_INLINE Float interpolated(const float (&plane)[3], Float y, Float z) {
  return hn::Add(hn::Add(all(plane[0]), hn::Mul(all(plane[1]), y)), hn::Mul(all(plane[2]), z));
}

HWY_INLINE Double metric_depth_of(const TrianglePlanes& t, const Weights& weights) {
  const Double lowest = all(t.lowest), highest = all(t.highest);
  const Double depth = interpolated(t.metric_depth, weights.exact.y, weights.exact.z);
  if (t.is_in_front) {
    const Double not_above = hn::IfThenElse(hn::Lt(highest, depth), highest, depth);
    return hn::IfThenElse(hn::Lt(depth, lowest), lowest, not_above);
  }
  const Mask is_within = hn::And(hn::Ge(depth, lowest), hn::Le(depth, highest));
  return hn::IfThenElse(is_within, depth, interpolated(t.metric_depth, weights.clamped.y, weights.clamped.z));
}

/// normalised() of triangle_view.cpp; zero without direction.
HWY_INLINE Vector3<Double> normalised(const Vector3<Double>& v) {
  const Double zero = hn::Zero(doubles);
  const Double largest = larger(larger(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
  const Vector3<Double> scaled = over(v, largest);
  const Double length = hn::Sqrt(dot(scaled, scaled));
  const Mask has_size = hn::And(hn::Gt(largest, zero), hn::Le(largest, all(hwy::HighestValue<double>())));
  const Vector3<Double> none = {zero, zero, zero};
  return choose(hn::And(has_size, hn::Gt(length, zero)), over(scaled, length), none);
}

/// Texture coordinates as apply_texture() of surface_point.cpp has them.
HWY_INLINE Double texture_coordinate(const double (&vertices)[3], const Vector3<Double>& weights) {
  const Double first = hn::Add(hn::Zero(doubles), hn::Mul(all(vertices[0]), weights.x));
  return hn::Add(hn::Add(first, hn::Mul(all(vertices[1]), weights.y)), hn::Mul(all(vertices[2]), weights.z));
}

/// One coordinate's change per pixel; see texture_derivatives_at().
HWY_INLINE Double texture_change(const TrianglePlanes& t, const Weights& weights, int coordinate, int axis) {
  const double(&vertices)[3] = t.texture[coordinate];
  const Vector3<Double> at = {all(vertices[0]), all(vertices[1]), all(vertices[2])};
  const Double here = hn::Div(dot(at, weights.edges), weights.sum);
  Double change = hn::Zero(doubles);
  for (int i = 0; i < 3; ++i)
    change = hn::Add(change, hn::Mul(hn::Sub(all(vertices[i]), here), all(t.edge_gradient[i][axis])));
  return hn::Div(change, weights.sum);
}

HWY_INLINE void lay_texture(const TrianglePlanes& t, const Weights& weights, std::size_t i, SurfaceRow& row) {
  Double change[2][2];  // per axis of the picture, of each coordinate
  for (int k = 0; k < 2; ++k) {
    hn::StoreU(texture_coordinate(t.texture[k], weights.clamped), doubles, row.texture_at[k] + i);
    for (int axis = 0; axis < 2; ++axis) {
      change[axis][k] = t.is_texture_constant ? hn::Zero(doubles) : texture_change(t, weights, k, axis);
    }
  }
  const auto square = [](const Double(&v)[2]) { return hn::Add(hn::Mul(v[0], v[0]), hn::Mul(v[1], v[1])); };
  const Double size = hn::Add(square(change[0]), square(change[1]));
  const Mask is_finite = hn::Le(size, all(hwy::HighestValue<double>()));
  for (int k = 0; k < 2; ++k) {
    hn::StoreU(hn::IfThenElseZero(is_finite, change[0][k]), doubles, row.texture_dx[k] + i);
    hn::StoreU(hn::IfThenElseZero(is_finite, change[1][k]), doubles, row.texture_dy[k] + i);
  }
}

/// Position and the direction to the viewer.
HWY_INLINE void place(const TrianglePlanes& t, const Weights& weights, std::size_t i, SurfaceRow& row) {
  Double position[3];
  for (int axis = 0; axis < 3; ++axis) {
    position[axis] = interpolated(t.world[axis], weights.clamped.y, weights.clamped.z);
    hn::StoreU(position[axis], doubles, row.position[axis] + i);
  }
  Vector3<Double> direction = {all(t.eye[0]), all(t.eye[1]), all(t.eye[2])};
  if (t.has_place) {
    direction = {hn::Sub(direction.x, position[0]), hn::Sub(direction.y, position[1]),
                 hn::Sub(direction.z, position[2])};
  }
  const Vector3<Double> to_viewer = normalised(direction);
  hn::StoreU(to_viewer.x, doubles, row.to_viewer[0] + i);
  hn::StoreU(to_viewer.y, doubles, row.to_viewer[1] + i);
  hn::StoreU(to_viewer.z, doubles, row.to_viewer[2] + i);
}

HWY_INLINE void turn(const TrianglePlanes& t, Float y, Float z, std::size_t i, SurfaceRow& row) {
  const Vector3<Float> sum = {interpolated(t.normal[0], y, z), interpolated(t.normal[1], y, z),
                              interpolated(t.normal[2], y, z)};
  const Vector3<Float> geometric = {all(t.geometric_normal[0]), all(t.geometric_normal[1]),
                                    all(t.geometric_normal[2])};
  const Float length = hn::Sqrt(dot(sum, sum));
  const Vector3<Float> normal = choose(hn::Gt(length, hn::Zero(floats)), over(sum, length), geometric);
  hn::StoreU(normal.x, floats, row.normal[0] + i);
  hn::StoreU(normal.y, floats, row.normal[1] + i);
  hn::StoreU(normal.z, floats, row.normal[2] + i);
}

}  // namespace

void interpolate_surface(const SurfaceWork& work) {
  const TrianglePlanes& t = *work.triangle;
  SurfaceRow& row = *work.row;
  for (std::size_t i = work.begin; i < work.end; i += hn::Lanes(doubles)) {
    const Double x =
        hn::Add(hn::Iota(doubles, 0), hn::Set(doubles, static_cast<double>(work.x) + static_cast<double>(i)));
    const Weights weights = weights_at(t, hn::Add(x, all(0.5)), work.y + 0.5);
    const Float weight_y = hn::DemoteTo(floats, weights.clamped.y);
    const Float weight_z = hn::DemoteTo(floats, weights.clamped.z);
    hn::StoreU(hn::DemoteTo(floats, weights.clamped.x), floats, row.barycentric[0] + i);
    hn::StoreU(weight_y, floats, row.barycentric[1] + i);
    hn::StoreU(weight_z, floats, row.barycentric[2] + i);
    if (work.needs.viewer) place(t, weights, i, row);
    if (work.needs.metric_depth) hn::StoreU(metric_depth_of(t, weights), doubles, row.metric_depth + i);
    if (work.needs.normal) turn(t, weight_y, weight_z, i, row);
    if (work.needs.texture) lay_texture(t, weights, i, row);
    if (!work.needs.colour) continue;
    for (int channel = 0; channel < 4; ++channel)
      hn::StoreU(interpolated(t.colour[channel], weight_y, weight_z), floats, row.colour[channel] + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

InterpolateSurface interpolate_surface_kernel(Isa isa) {
  static constexpr auto versions = VELUM_KERNEL_VERSIONS(interpolate_surface);
  return versions.at(isa);
}

}  // namespace velum
#endif
