#include "geometry_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/set_up_simd.cpp"
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
using Ints = hn::Rebind<std::int32_t, Doubles>;
using Double = hn::Vec<Doubles>;
using Mask = hn::Mask<Doubles>;
constexpr Doubles doubles;
constexpr Floats floats;
constexpr Ints ints;
constexpr std::size_t most_lanes = 8;

/// The vertices of as many triangles as a vector has lanes: coordinate after coordinate.
struct Gathered {
  HWY_ALIGN double clip[3][4][most_lanes];  ///< vertex, coordinate, triangle
  HWY_ALIGN std::int32_t x[3][most_lanes];
  HWY_ALIGN std::int32_t y[3][most_lanes];
  std::uint32_t triangle[most_lanes];
};

/// Fetches triangles that need no clipping, beginning with `next`, until the lanes are full; the others'
/// numbers go to work.slow.
/// @return how many were found; `next` stands behind the last one looked at
HWY_INLINE std::size_t gather(const SetUpWork& work, std::uint32_t& next, Gathered& out, std::size_t& slow) {
  const std::size_t lanes = hn::Lanes(doubles);
  std::size_t lane = 0;
  for (; next < work.last && lane < lanes; ++next) {
    const std::uint32_t* const indices = work.indices + 3 * static_cast<std::size_t>(next);
    const PlacedVertex a = work.placed[indices[0]];
    const PlacedVertex b = work.placed[indices[1]];
    const PlacedVertex c = work.placed[indices[2]];
    if (a.x == not_snapped || b.x == not_snapped || c.x == not_snapped) {
      work.slow[slow++] = next;
      continue;
    }
    out.x[0][lane] = a.x, out.x[1][lane] = b.x, out.x[2][lane] = c.x;
    out.y[0][lane] = a.y, out.y[1][lane] = b.y, out.y[2][lane] = c.y;
    for (int v = 0; v < 3; ++v) {
      const double* const vertex = work.clip + 4 * static_cast<std::size_t>(indices[v]);
      for (int i = 0; i < 4; ++i) out.clip[v][i][lane] = vertex[i];
    }
    out.triangle[lane++] = next;
  }
  return lane;
}

struct Vector3 {
  Double x, y, z;
};

HWY_INLINE Double product_difference(Double a, Double b, Double c, Double d) {
  return hn::Sub(hn::Mul(a, b), hn::Mul(c, d));
}
HWY_INLINE Vector3 cross(const Vector3& a, const Vector3& b) {
  return {product_difference(a.y, b.z, b.y, a.z), product_difference(a.z, b.x, b.z, a.x),
          product_difference(a.x, b.y, b.x, a.y)};
}
HWY_INLINE Vector3 difference(const Vector3& a, const Vector3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Double dot(const Vector3& a, const Vector3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

/// A vertex (x, y, w), and w - z.
struct Vertex {
  Vector3 position;
  Double r;
};
HWY_INLINE Vertex vertex_of(const Gathered& g, int v) {
  const Double w = hn::Load(doubles, g.clip[v][3]);
  return {{hn::Load(doubles, g.clip[v][0]), hn::Load(doubles, g.clip[v][1]), w},
          hn::Sub(w, hn::Load(doubles, g.clip[v][2]))};
}

/// Facing and depth plane: homogeneous_determinant() and plane_in_ndc(), operation for operation.
struct Plane {
  Double determinant;
  Vector3 ndc;
};
HWY_INLINE Plane plane_of(const Vertex& a, const Vertex& b, const Vertex& c) {
  const Vector3 d1 = difference(b.position, a.position);
  const Vector3 d2 = difference(c.position, a.position);
  const Double r1 = hn::Sub(b.r, a.r);
  const Double r2 = hn::Sub(c.r, a.r);
  const Vector3 normal = cross(d1, d2);
  const Vector3 along1 = cross(d2, a.position);
  const Vector3 along2 = cross(a.position, d1);
  const Double determinant = dot(a.position, normal);
  const auto component = [&](Double n, Double p, Double q) {
    const Double sum = hn::Add(hn::Add(hn::Mul(n, a.r), hn::Mul(p, r1)), hn::Mul(q, r2));
    return hn::Div(sum, determinant);
  };
  return {determinant,
          {component(normal.x, along1.x, along2.x), component(normal.y, along1.y, along2.y),
           component(normal.z, along1.z, along2.z)}};
}

HWY_INLINE Double unit(Double r) {
  const Double one = hn::Set(doubles, 1.0);
  return hn::IfThenElseZero(hn::Gt(r, hn::Zero(doubles)), hn::IfThenElse(hn::Lt(r, one), r, one));
}

HWY_INLINE Mask is_steep(Double slope) {
  const Double steepest = hn::Set(doubles, 1e30);
  return hn::Not(hn::And(hn::Le(slope, steepest), hn::Ge(slope, hn::Neg(steepest))));
}

/// What depth_plane() gives, lane by lane, in memory.
struct DepthLanes {
  HWY_ALIGN float r_ref[most_lanes], dx[most_lanes], dy[most_lanes], lower[most_lanes], upper[most_lanes];
  HWY_ALIGN std::int32_t x_ref[most_lanes], y_ref[most_lanes];
};

/// The pixel column (row) of a coordinate, kept inside the picture.
HWY_INLINE Double pixel_of(Double coordinate, int size) {
  const Double last = hn::Set(doubles, size - 1.0);
  const Double from_zero = hn::IfThenZeroElse(hn::Lt(coordinate, hn::Zero(doubles)), coordinate);
  return hn::Floor(hn::IfThenElse(hn::Lt(last, from_zero), last, from_zero));
}

HWY_INLINE void store(Double value, Mask where, float* out) {
  hn::Store(hn::DemoteTo(floats, hn::IfThenElseZero(where, value)), floats, out);
}

/// depth_plane() for vertices with w > 0.
HWY_INLINE void set_up_depth(const SetUpWork& work, const Vertex (&v)[3], const Plane& plane,
                             DepthLanes& out) {
  const Double zero = hn::Zero(doubles), half = hn::Set(doubles, 0.5), one = hn::Set(doubles, 1.0),
               two = hn::Set(doubles, 2.0);
  const Double width = hn::Set(doubles, work.width), height = hn::Set(doubles, work.height);

  Double nearest = hn::Div(v[0].r, v[0].position.z);
  Double farthest = nearest;
  Vector3 at = v[0].position;
  for (int i = 1; i < 3; ++i) {
    const Double r = hn::Div(v[i].r, v[i].position.z);
    const Mask is_farther = hn::Lt(r, farthest);
    farthest = hn::IfThenElse(is_farther, r, farthest);
    nearest = hn::IfThenElse(hn::Gt(r, nearest), r, nearest);
    at.x = hn::IfThenElse(is_farther, v[i].position.x, at.x);
    at.y = hn::IfThenElse(is_farther, v[i].position.y, at.y);
    at.z = hn::IfThenElse(is_farther, v[i].position.z, at.z);
  }
  const Double upper = unit(nearest);

  const Double dx = hn::Div(hn::Mul(plane.ndc.x, two), width);
  const Double dy = hn::Div(hn::Mul(hn::Neg(plane.ndc.y), two), height);
  const Mask is_flat = hn::Or(hn::Or(hn::Eq(plane.determinant, zero), is_steep(dx)),
                              hn::Or(is_steep(dy), is_steep(plane.ndc.z)));
  const Mask is_sloped = hn::Not(is_flat);

  const Double px = hn::Mul(hn::Mul(half, width), hn::Add(hn::Div(at.x, at.z), one));
  const Double py = hn::Mul(hn::Mul(half, height), hn::Sub(one, hn::Div(at.y, at.z)));
  const Double x_ref = pixel_of(px, work.width);
  const Double y_ref = pixel_of(py, work.height);
  const Double cx = hn::Sub(hn::Div(hn::Mul(two, hn::Add(x_ref, half)), width), one);
  const Double cy = hn::Sub(one, hn::Div(hn::Mul(two, hn::Add(y_ref, half)), height));
  const Double r_ref = hn::Add(hn::Add(hn::Mul(plane.ndc.x, cx), hn::Mul(plane.ndc.y, cy)), plane.ndc.z);

  const auto all = hn::Eq(zero, zero);
  store(hn::IfThenElse(is_flat, upper, unit(farthest)), all, out.lower);
  store(upper, all, out.upper);
  store(dx, is_sloped, out.dx);
  store(dy, is_sloped, out.dy);
  // + 0 makes -0 +0, as in depth_plane(); after the rounding to float, which can make a -0.
  const auto r = hn::DemoteTo(floats, hn::IfThenElse(is_flat, upper, r_ref));
  hn::Store(hn::Add(r, hn::Zero(floats)), floats, out.r_ref);
  hn::Store(hn::DemoteTo(ints, hn::IfThenElseZero(is_sloped, x_ref)), ints, out.x_ref);
  hn::Store(hn::DemoteTo(ints, hn::IfThenElseZero(is_sloped, y_ref)), ints, out.y_ref);
}

struct SnappedLanes {
  Double x[3], y[3];
};

HWY_INLINE SnappedLanes snapped_of(const Gathered& g) {
  SnappedLanes s;
  for (int v = 0; v < 3; ++v) {
    s.x[v] = hn::PromoteTo(doubles, hn::Load(ints, g.x[v]));
    s.y[v] = hn::PromoteTo(doubles, hn::Load(ints, g.y[v]));
  }
  return s;
}

/// doubled_area(): exact, since coordinates have 24 bits.
HWY_INLINE Double doubled_area(const SnappedLanes& s) {
  return product_difference(hn::Sub(s.x[1], s.x[0]), hn::Sub(s.y[2], s.y[0]), hn::Sub(s.y[1], s.y[0]),
                            hn::Sub(s.x[2], s.x[0]));
}

/// Whether a pixel centre first + ½ … end - ½ lies between the smallest and largest coordinate.
HWY_INLINE Mask holds_a_centre(const Double (&v)[3], int first, int end) {
  const Double pixel = hn::Set(doubles, 1.0 / 256.0), half = hn::Set(doubles, 0.5);
  const Double lowest = hn::Mul(hn::Min(v[0], hn::Min(v[1], v[2])), pixel);
  const Double highest = hn::Mul(hn::Max(v[0], hn::Max(v[1], v[2])), pixel);
  const Double from = hn::Max(hn::Ceil(hn::Sub(lowest, half)), hn::Set(doubles, first));
  const Double to = hn::Min(hn::Floor(hn::Sub(highest, half)), hn::Set(doubles, end - 1.0));
  return hn::Le(from, to);
}

HWY_INLINE std::uint32_t bits_of(Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(doubles, mask, bits);
  return bits[0];
}

/// Writes one triangle, turned clockwise.
HWY_INLINE void write(const SetUpWork& work, const Gathered& g, const DepthLanes& depth, std::size_t i,
                      bool is_clockwise, RasterTriangle& out) {
  const int second = is_clockwise ? 1 : 2, third = is_clockwise ? 2 : 1;
  out.x[0] = g.x[0][i], out.x[1] = g.x[second][i], out.x[2] = g.x[third][i];
  out.y[0] = g.y[0][i], out.y[1] = g.y[second][i], out.y[2] = g.y[third][i];
  out.r_ref = depth.r_ref[i];
  out.dx = depth.dx[i];
  out.dy = depth.dy[i];
  out.x_ref = depth.x_ref[i];
  out.y_ref = depth.y_ref[i];
  out.lower = depth.lower[i];
  out.upper = depth.upper[i];
  out.primitive = work.first_primitive + g.triangle[i];
}

/// @return how many of the `count` triangles were written to `out`
HWY_INLINE std::size_t set_up_lanes(const SetUpWork& work, const Gathered& g, std::size_t count,
                                    RasterTriangle* out, SetUpCounts& counts) {
  const std::uint32_t present = (1u << count) - 1u;
  const Vertex v[3] = {vertex_of(g, 0), vertex_of(g, 1), vertex_of(g, 2)};
  const Plane plane = plane_of(v[0], v[1], v[2]);
  const Double zero = hn::Zero(doubles);
  const std::uint32_t positive = bits_of(hn::Gt(plane.determinant, zero)) & present;
  const std::uint32_t negative = bits_of(hn::Lt(plane.determinant, zero)) & present;
  const std::uint32_t edge_on = bits_of(hn::Eq(plane.determinant, zero)) & present;
  const std::uint32_t neither = present & ~(positive | negative);  // edge-on, or too large for a number
  counts.edge_on += hwy::PopCount(edge_on);
  counts.back_facing += hwy::PopCount(work.is_back_positive ? positive : negative);
  const std::uint32_t culled = (work.cull_positive ? positive : 0u) | (work.cull_negative ? negative : 0u) |
                               (work.cull_zero ? neither : 0u);
  const std::uint32_t kept = present & ~culled;
  counts.culled += hwy::PopCount(culled);
  counts.accepted += hwy::PopCount(kept);
  counts.screen_triangles += hwy::PopCount(kept);

  const SnappedLanes s = snapped_of(g);
  const Double area = doubled_area(s);
  const std::uint32_t clockwise = bits_of(hn::Gt(area, zero));
  const std::uint32_t with_area = bits_of(hn::Ne(area, zero));
  // y points down on the picture, so counter-clockwise triangles have a negative doubled area there.
  counts.reversed += hwy::PopCount(kept & with_area & ~(clockwise ^ (positive | edge_on)));
  counts.zero_area += hwy::PopCount(kept & ~with_area);
  std::uint32_t left = kept & with_area &
                       bits_of(hn::And(holds_a_centre(s.x, work.target_left, work.target_right),
                                       holds_a_centre(s.y, work.target_top, work.target_bottom)));
  if (left == 0) return 0;

  DepthLanes depth;
  set_up_depth(work, v, plane, depth);
  std::size_t written = 0;
  for (; left != 0; left &= left - 1) {
    const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
    write(work, g, depth, i, ((clockwise >> i) & 1u) != 0, out[written++]);
  }
  return written;
}

}  // namespace

SetUpResult set_up_triangles(const SetUpWork& work, SetUpCounts& counts) {
  SetUpResult result{0, 0};
  Gathered gathered = {};
  for (std::uint32_t next = work.first; next < work.last;) {
    const std::size_t count = gather(work, next, gathered, result.slow);
    if (count == 0) break;
    result.triangles += set_up_lanes(work, gathered, count, work.out + result.triangles, counts);
  }
  return result;
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

SetUpTriangles set_up_kernel(Isa isa) {
  static constexpr auto versions = VELUM_KERNEL_VERSIONS(set_up_triangles);
  return versions.at(isa);
}

}  // namespace velum
#endif
