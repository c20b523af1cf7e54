// One ray against four triangles, exactly. Highway reads this file once per instruction set, so its guard
// turns with the target.
#if defined(VELUM_WIDE_EXACT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_WIDE_EXACT_INL
#undef VELUM_WIDE_EXACT_INL
#else
#define VELUM_WIDE_EXACT_INL
#endif

#include <hwy/highway.h>

#include "wide_cast_kernels.hpp"
#include "wide_float_ray-inl.hpp"
#include "wide_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// As PreparedRay, by the same operations.
struct ExactRay {
  std::size_t axis[3];  ///< kx, ky, kz
  double origin[3];     ///< along those
  double shear_x, shear_y, scale_z;
  double ahead[3], behind[3], inverse[3];  ///< x, y, z

  HWY_INLINE void set(const WideQuery& query) {
    set_axes(query);
    double reach = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double to_lower = size_of(static_cast<double>(query.bounds->lower[i]) - query.origin[i]);
      const double to_upper = size_of(static_cast<double>(query.bounds->upper[i]) - query.origin[i]);
      reach = reach < to_lower ? to_lower : reach;
      reach = reach < to_upper ? to_upper : reach;
    }
    const double margin = 0x1p-48 * reach;
    constexpr double largest = 0x1p1000;
    for (std::size_t i = 0; i < 3; ++i) {
      ahead[i] = query.origin[i] + margin;
      behind[i] = query.origin[i] - margin;
      const double v = query.direction[i], bounded = v < 0.0 ? -largest : largest;
      const double quotient = 1.0 / v;
      inverse[i] = size_of(v) > 1.0 / largest ? quotient : bounded;
      origin[i] = query.origin[axis[i]];
    }
    scale_z = inverse[axis[2]];
    shear_x = query.direction[axis[0]] * scale_z;
    shear_y = query.direction[axis[1]] * scale_z;
  }

 private:
  HWY_INLINE void set_axes(const WideQuery& query) {
    const double x = size_of(query.direction[0]), y = size_of(query.direction[1]);
    const double z = size_of(query.direction[2]);
    const bool is_z = !((x < y ? y : x) > z);
    axis[2] = is_z ? 2u : 1u - static_cast<std::size_t>(x > y);
    constexpr std::size_t next[3] = {1, 2, 0};
    axis[0] = next[axis[2]];
    axis[1] = next[axis[0]];
  }
};

/// Some triangles of a block as the ray sees them.
struct SeenTriangles {
  hn::Vec<Triangles> x[3], y[3], z[3];  ///< of the corners; z not scaled
  hn::Vec<Triangles> edge[3];           ///< on which side of b → c, c → a, a → b the ray passes

  HWY_INLINE SeenTriangles(const TriangleBlock& block, const ExactRay& ray, std::size_t first) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto along = [&](std::size_t k) HWY_ATTR {
        const float* corners = block.corner[c][ray.axis[k]] + first;
        const auto place = hn::PromoteTo(triangles, hn::Load(triangles_in_memory, corners));
        return hn::Sub(place, hn::Set(triangles, ray.origin[k]));
      };
      z[c] = along(2);
      x[c] = hn::Sub(along(0), hn::Mul(hn::Set(triangles, ray.shear_x), z[c]));
      y[c] = hn::Sub(along(1), hn::Mul(hn::Set(triangles, ray.shear_y), z[c]));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t p = (i + 1) % 3, q = (i + 2) % 3;
      edge[i] = hn::Sub(hn::Mul(x[p], y[q]), hn::Mul(y[p], x[q]));
    }
  }
  HWY_INLINE hn::Vec<Triangles> least() const { return hn::Min(hn::Min(edge[0], edge[1]), edge[2]); }
  HWY_INLINE hn::Vec<Triangles> most() const { return hn::Max(hn::Max(edge[0], edge[1]), edge[2]); }
};

/// Where the ray is inside the triangles' boxes: PreparedRay::through(). Of 0 and -0 the second argument is
/// taken, so the order of arguments matters.
struct InsideBoxes {
  hn::Vec<Triangles> lower, upper;

  HWY_INLINE InsideBoxes(const TriangleBlock& block, const ExactRay& ray, std::size_t first) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto side = [&](auto nearer) HWY_ATTR {
        const auto corner = [&](std::size_t c) HWY_ATTR {
          return hn::Load(triangles_in_memory, block.corner[c][axis] + first);
        };
        return hn::PromoteTo(triangles, nearer(corner(2), nearer(corner(1), corner(0))));
      };
      const auto low = side([](auto a, auto b) HWY_ATTR { return hn::Min(a, b); });
      const auto high = side([](auto a, auto b) HWY_ATTR { return hn::Max(a, b); });
      const auto inverse = hn::Set(triangles, ray.inverse[axis]);
      const auto one = hn::Mul(hn::Sub(low, hn::Set(triangles, ray.ahead[axis])), inverse);
      const auto other = hn::Mul(hn::Sub(high, hn::Set(triangles, ray.behind[axis])), inverse);
      const auto entry = hn::Min(one, other), exit = hn::Max(other, one);
      lower = axis == 0 ? entry : hn::Max(entry, lower);
      upper = axis == 0 ? exit : hn::Min(exit, upper);
    }
  }
};

/// What the ray meets in a block.
struct MetTriangles {
  HWY_ALIGN double t[4];
  HWY_ALIGN double barycentric[3][4];
  std::uint32_t met = 0;       ///< hit at t, or, if in doubt, perhaps hit: one bit each
  std::uint32_t in_doubt = 0;  ///< the ray passes exactly through an edge

  HWY_INLINE MetTriangles(const TriangleBlock& block, const ExactRay& ray, double from, double to) {
    const auto zero = hn::Zero(triangles);
    for (std::size_t i = 0; i < 4; i += hn::Lanes(triangles)) {
      const SeenTriangles seen(block, ray, i);
      const auto least = seen.least(), most = seen.most();
      const auto perhaps = hn::Or(hn::Ge(least, zero), hn::Le(most, zero));
      if (hn::AllFalse(triangles, perhaps)) continue;
      const auto doubt = hn::And(perhaps, hn::Or(hn::Eq(least, zero), hn::Eq(most, zero)));
      const auto determinant = hn::Add(hn::Add(seen.edge[0], seen.edge[1]), seen.edge[2]);
      const auto scale = hn::Set(triangles, ray.scale_z);
      hn::Vec<Triangles> share[3], part[3];
      for (std::size_t c = 0; c < 3; ++c) {
        share[c] = hn::Div(seen.edge[c], determinant);
        part[c] = hn::Mul(share[c], hn::Mul(scale, seen.z[c]));
        hn::Store(share[c], triangles, barycentric[c] + i);
      }
      const auto at = hn::Add(hn::Add(part[0], part[1]), part[2]);
      const InsideBoxes box(block, ray, i);
      const auto clamped = hn::IfThenElse(hn::Lt(at, box.lower), box.lower,
                                          hn::IfThenElse(hn::Lt(box.upper, at), box.upper, at));
      hn::Store(clamped, triangles, t + i);
      const auto is_wanted =
          hn::And(hn::Ge(clamped, hn::Set(triangles, from)), hn::Le(clamped, hn::Set(triangles, to)));
      const auto is_there = hn::And(hn::Le(box.lower, box.upper), hn::Eq(at, at));
      met |= bits_of(triangles, hn::And(perhaps, hn::Or(doubt, hn::And(is_wanted, is_there)))) << i;
      in_doubt |= bits_of(triangles, doubt) << i;
    }
  }
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif
