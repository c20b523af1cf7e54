// The depth plane of triangles in double, lane by lane; see set_up_simd.cpp.
#if defined(VELUM_SET_UP_DEPTH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_SET_UP_DEPTH_INL
#undef VELUM_SET_UP_DEPTH_INL
#else
#define VELUM_SET_UP_DEPTH_INL
#endif

#include "clip_position-inl.hpp"
#include "geometry_kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// Triangles are set up this many at a time, pass after pass over arrays that stay in the nearest cache.
constexpr std::uint32_t chunk_size = 64;
/// Arrays have room for a whole vector behind the last triangle.
constexpr std::size_t chunk_room = chunk_size + 16;

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
/// @param positions  x, y, z and anything, of as many vertices as a vector has lanes; object space
HWY_INLINE Vertex load_vertices(const SetUpWork& work, const float* positions) {
  hn::Vec<NarrowFloats> px, py, pz, unused;
  hn::LoadInterleaved4(narrow_floats, positions, px, py, pz, unused);
  const ClipVector v = clip_position(work.clip_from_object, px, py, pz);
  return {{v.x, v.y, v.w}, hn::Sub(v.w, v.z)};
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
  const Double one = hn::Set(doubles, 1.0);
  const Mask is_tiny = hn::Lt(hn::Abs(determinant), hn::Set(doubles, 0x1p-960));
  const Double scale = hn::IfThenElse(is_tiny, hn::Set(doubles, 0x1p+300), one);
  const Double inverse = hn::Div(one, hn::Mul(determinant, scale));
  const auto component = [&](Double n, Double p, Double q) {
    const Double sum = hn::Add(hn::Add(hn::Mul(n, a.r), hn::Mul(p, r1)), hn::Mul(q, r2));
    return hn::Mul(hn::Mul(sum, scale), inverse);
  };
  return {determinant,
          {component(normal.x, along1.x, along2.x), component(normal.y, along1.y, along2.y),
           component(normal.z, along1.z, along2.z)}};
}

HWY_INLINE Mask is_steep(Double slope) {
  const Double steepest = hn::Set(doubles, 1e30);
  return hn::Not(hn::And(hn::Le(slope, steepest), hn::Ge(slope, hn::Neg(steepest))));
}

/// What depth_plane() gives, triangle by triangle.
struct PlaneArrays {
  HWY_ALIGN float r_ref[chunk_room], dx[chunk_room], dy[chunk_room], lower[chunk_room], upper[chunk_room];
  HWY_ALIGN std::int32_t x_ref[chunk_room], y_ref[chunk_room];
};

/// The pixel column (row) of a coordinate, kept inside the picture.
HWY_INLINE Double pixel_of(Double coordinate, int size) {
  const Double last = hn::Set(doubles, size - 1.0);
  const Double from_zero = hn::IfThenZeroElse(hn::Lt(coordinate, hn::Zero(doubles)), coordinate);
  return hn::Floor(hn::IfThenElse(hn::Lt(last, from_zero), last, from_zero));
}

HWY_INLINE void store(Double value, Mask where, float* out) {
  hn::StoreU(hn::DemoteTo(narrow_floats, hn::IfThenElseZero(where, value)), narrow_floats, out);
}

/// depth_plane() for vertices with w > 0. @param first  where the lanes' results begin in `out`
HWY_INLINE void set_up_depth(const SetUpWork& work, const Vertex (&v)[3], const Plane& plane,
                             std::size_t first, PlaneArrays& out) {
  const Double zero = hn::Zero(doubles), half = hn::Set(doubles, 0.5), one = hn::Set(doubles, 1.0);
  const Double ndc_per_column = hn::Set(doubles, 2.0 / work.width);
  const Double ndc_per_row = hn::Set(doubles, 2.0 / work.height);

  Double inverse_w = hn::Div(one, v[0].position.z);
  Double nearest = hn::Mul(v[0].r, inverse_w);
  Double farthest = nearest;
  Double at_x = v[0].position.x, at_y = v[0].position.y;  // of the farthest
  for (int i = 1; i < 3; ++i) {
    const Double inverse = hn::Div(one, v[i].position.z);
    const Double r = hn::Mul(v[i].r, inverse);
    const Mask is_farther = hn::Lt(r, farthest);
    farthest = hn::IfThenElse(is_farther, r, farthest);
    nearest = hn::IfThenElse(hn::Gt(r, nearest), r, nearest);
    at_x = hn::IfThenElse(is_farther, v[i].position.x, at_x);
    at_y = hn::IfThenElse(is_farther, v[i].position.y, at_y);
    inverse_w = hn::IfThenElse(is_farther, inverse, inverse_w);
  }
  const Double upper = unit(nearest);

  const Double dx = hn::Mul(plane.ndc.x, ndc_per_column);
  const Double dy = hn::Mul(hn::Neg(plane.ndc.y), ndc_per_row);
  const Mask is_flat = hn::Or(hn::Or(hn::Eq(plane.determinant, zero), is_steep(dx)),
                              hn::Or(is_steep(dy), is_steep(plane.ndc.z)));
  const Mask is_sloped = hn::Not(is_flat);

  const Double half_width = hn::Set(doubles, 0.5 * work.width);
  const Double half_height = hn::Set(doubles, 0.5 * work.height);
  const Double px = hn::Mul(half_width, hn::Add(hn::Mul(at_x, inverse_w), one));
  const Double py = hn::Mul(half_height, hn::Sub(one, hn::Mul(at_y, inverse_w)));
  const Double x_ref = pixel_of(px, work.width);
  const Double y_ref = pixel_of(py, work.height);
  const Double cx = hn::Sub(hn::Mul(hn::Add(x_ref, half), ndc_per_column), one);
  const Double cy = hn::Sub(one, hn::Mul(hn::Add(y_ref, half), ndc_per_row));
  const Double r_ref = hn::Add(hn::Add(hn::Mul(plane.ndc.x, cx), hn::Mul(plane.ndc.y, cy)), plane.ndc.z);

  const auto all = hn::Eq(zero, zero);
  store(hn::IfThenElse(is_flat, upper, unit(farthest)), all, out.lower + first);
  store(upper, all, out.upper + first);
  store(dx, is_sloped, out.dx + first);
  store(dy, is_sloped, out.dy + first);
  // + 0 makes -0 +0, as in depth_plane(); after the rounding to float, which can make a -0.
  const auto r =
      hn::Add(hn::DemoteTo(narrow_floats, hn::IfThenElse(is_flat, upper, r_ref)), hn::Zero(narrow_floats));
  const auto along_x =
      hn::Mul(hn::LoadU(narrow_floats, out.dx + first), hn::Set(narrow_floats, work.sample_x));
  const auto along_y =
      hn::Mul(hn::LoadU(narrow_floats, out.dy + first), hn::Set(narrow_floats, work.sample_y));
  hn::StoreU(hn::Add(r, hn::Add(along_x, along_y)), narrow_floats, out.r_ref + first);
  hn::StoreU(hn::DemoteTo(narrow_ints, hn::IfThenElseZero(is_sloped, x_ref)), narrow_ints, out.x_ref + first);
  hn::StoreU(hn::DemoteTo(narrow_ints, hn::IfThenElseZero(is_sloped, y_ref)), narrow_ints, out.y_ref + first);
}

/// Vertices fetched for triangles: x, y, z and room for one more, vertex by vertex; object space. They are
/// transformed once more rather than kept in clip space, where they take 32 bytes and not 12: memory is what
/// is short.
struct FetchedVertices {
  HWY_ALIGN float position[3][4 * chunk_room];

  HWY_INLINE Vertex load(const SetUpWork& work, int vertex, std::size_t first) const {
    return load_vertices(work, position[vertex] + 4 * first);
  }
};

/// The depth planes of the first `count` triangles fetched.
HWY_INLINE void set_up_depths(const SetUpWork& work, const FetchedVertices& vertices, std::size_t count,
                              PlaneArrays& out) {
  for (std::size_t i = 0; i < count; i += hn::Lanes(doubles)) {
    const Vertex v[3] = {vertices.load(work, 0, i), vertices.load(work, 1, i), vertices.load(work, 2, i)};
    set_up_depth(work, v, plane_of(v[0], v[1], v[2]), i, out);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif  // the guard that turns with the target
