// Eight rays against one triangle, exactly. Highway reads this file once per instruction set, so its guard
// turns with the target.
#if defined(VELUM_WIDE_PACKET_EXACT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_WIDE_PACKET_EXACT_INL
#undef VELUM_WIDE_PACKET_EXACT_INL
#else
#define VELUM_WIDE_PACKET_EXACT_INL
#endif

#include <hwy/highway.h>

#include "wide_float_ray-inl.hpp"
#include "wide_lanes-inl.hpp"
#include "wide_packet_kernels.hpp"
#include "wide_stack-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

using Rays = hn::CappedTag<double, PacketQuery::size>;
constexpr Rays rays;
using SomeRays = hn::Vec<Rays>;

/// Eight rays side by side as PreparedRay has them, by the same operations.
struct PacketLines {
  HWY_ALIGN double number[8][PacketQuery::size];  ///< origin, direction, lower, upper
  HWY_ALIGN double ahead[3][PacketQuery::size];
  HWY_ALIGN double behind[3][PacketQuery::size];
  HWY_ALIGN double inverse[3][PacketQuery::size];
  HWY_ALIGN double shear[2][PacketQuery::size];  ///< x, y
  std::size_t axis[3];                           ///< kx, ky, kz, of all rays

  struct Sides {
    double low, high, low_slope, high_slope;
  };

  /// @return false if the rays do not share their longest axis
  HWY_INLINE bool set(const PacketQuery& query) {
    for (std::size_t r = 0; r < PacketQuery::size; ++r) {
      for (std::size_t i = 0; i < 8; ++i) number[i][r] = query.ray(r)[i];
    }
    if (!set_axes()) return false;
    for (std::size_t i = 0; i < PacketQuery::size; i += hn::Lanes(rays)) set_lines(query, i);
    return true;
  }

  HWY_INLINE SomeRays origin(std::size_t k, std::size_t i) const {
    return hn::Load(rays, number[axis[k]] + i);
  }

  /// Where along kz the first ray begins, seen in the direction of the rays.
  HWY_INLINE double least_start(double sign) const {
    auto least = hn::Set(rays, 1e300);
    for (std::size_t i = 0; i < PacketQuery::size; i += hn::Lanes(rays)) {
      const auto speed = hn::Abs(hn::Load(rays, number[3 + axis[2]] + i));
      const auto way = hn::Mul(hn::Load(rays, number[6] + i), speed);
      least = hn::Min(least, hn::Add(hn::Mul(origin(2, i), hn::Set(rays, sign)), way));
    }
    return hn::GetLane(hn::MinOfLanes(rays, least));
  }
  /// Between which places, along kx or ky, the rays are where they are at `start` along kz.
  HWY_INLINE Sides sides_at(std::size_t k, double start, double sign) const {
    auto low = hn::Set(rays, 1e300), high = hn::Set(rays, -1e300), low_slope = low, high_slope = high;
    for (std::size_t i = 0; i < PacketQuery::size; i += hn::Lanes(rays)) {
      const auto turn = hn::Set(rays, sign);
      const auto slope = hn::Mul(hn::Load(rays, shear[k] + i), turn);
      const auto way = hn::Sub(hn::Set(rays, start), hn::Mul(origin(2, i), turn));
      const auto place = hn::Add(origin(k, i), hn::Mul(way, slope));
      low = hn::Min(low, place);
      high = hn::Max(high, place);
      low_slope = hn::Min(low_slope, slope);
      high_slope = hn::Max(high_slope, slope);
    }
    return {hn::GetLane(hn::MinOfLanes(rays, low)), hn::GetLane(hn::MaxOfLanes(rays, high)),
            hn::GetLane(hn::MinOfLanes(rays, low_slope)), hn::GetLane(hn::MaxOfLanes(rays, high_slope))};
  }

 private:
  HWY_INLINE bool set_axes() {
    std::uint32_t is_x = 0, is_z = 0;
    for (std::size_t i = 0; i < PacketQuery::size; i += hn::Lanes(rays)) {
      const auto x = hn::Abs(hn::Load(rays, number[3] + i)), y = hn::Abs(hn::Load(rays, number[4] + i));
      const auto z = hn::Abs(hn::Load(rays, number[5] + i));
      is_x |= bits_of(rays, hn::Gt(x, y)) << i;
      is_z |= bits_of(rays, hn::Not(hn::Gt(hn::Max(x, y), z))) << i;
    }
    constexpr std::uint32_t all = 0xFF;
    const bool is_one = is_z == all || (is_z == 0 && (is_x == all || is_x == 0));
    axis[2] = is_z != 0 ? 2 : (is_x != 0 ? 0 : 1);
    axis[0] = axis[2] == 2 ? 0 : axis[2] + 1;
    axis[1] = axis[0] == 2 ? 0 : axis[0] + 1;
    return is_one;
  }

  HWY_INLINE void set_lines(const PacketQuery& query, std::size_t i) {
    auto reach = hn::Zero(rays);
    for (std::size_t a = 0; a < 3; ++a) {
      const auto from = hn::Load(rays, number[a] + i);
      const auto lower = hn::Set(rays, static_cast<double>(query.bounds->lower[a]));
      const auto upper = hn::Set(rays, static_cast<double>(query.bounds->upper[a]));
      reach = hn::Max(reach, hn::Max(hn::Abs(hn::Sub(lower, from)), hn::Abs(hn::Sub(upper, from))));
    }
    const auto margin = hn::Mul(hn::Set(rays, 0x1p-48), reach);
    const auto most = hn::Set(rays, 0x1p1000), least = hn::Set(rays, 0x1p-1000), one = hn::Set(rays, 1.0);
    for (std::size_t a = 0; a < 3; ++a) {
      const auto from = hn::Load(rays, number[a] + i), v = hn::Load(rays, number[3 + a] + i);
      hn::Store(hn::Add(from, margin), rays, ahead[a] + i);
      hn::Store(hn::Sub(from, margin), rays, behind[a] + i);
      const auto bounded = hn::IfThenElse(hn::Lt(v, hn::Zero(rays)), hn::Neg(most), most);
      const auto quotient = hn::IfThenElse(hn::Gt(hn::Abs(v), least), hn::Div(one, v), bounded);
      hn::Store(quotient, rays, inverse[a] + i);
    }
    const auto scale = hn::Load(rays, inverse[axis[2]] + i);
    for (std::size_t k = 0; k < 2; ++k)
      hn::Store(hn::Mul(hn::Load(rays, number[3 + axis[k]] + i), scale), rays, shear[k] + i);
  }
};

/// One triangle, of which all rays are told the same.
struct SharedTriangle {
  double corner[3][3];  ///< corner; along kx, ky, kz
  double lower[3], upper[3];
  std::uint32_t id;

  HWY_INLINE SharedTriangle(const TriangleBlock& block, std::size_t lane, const PacketLines& lines)
      : id(block.id[lane]) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t k = 0; k < 3; ++k)
        corner[c][k] = static_cast<double>(block.corner[c][lines.axis[k]][lane]);
    }
    for (std::size_t a = 0; a < 3; ++a) {
      const float p = block.corner[0][a][lane], q = block.corner[1][a][lane], r = block.corner[2][a][lane];
      const float less = q < p ? q : p, more = p < q ? q : p;
      lower[a] = static_cast<double>(r < less ? r : less);
      upper[a] = static_cast<double>(more < r ? r : more);
    }
  }
};

/// The rays of some lanes against a triangle: the operations of intersect_watertight().
struct SeenByRays {
  SomeRays z[3];     ///< of the corners; not scaled
  SomeRays edge[3];  ///< on which side of b → c, c → a, a → b the rays pass
  hn::Mask<Rays> perhaps, in_doubt;

  HWY_INLINE SeenByRays(const SharedTriangle& triangle, const PacketLines& lines, std::size_t i) {
    SomeRays x[3], y[3];
    for (std::size_t c = 0; c < 3; ++c) {
      const auto along = [&](std::size_t k) HWY_ATTR {
        return hn::Sub(hn::Set(rays, triangle.corner[c][k]), lines.origin(k, i));
      };
      z[c] = along(2);
      x[c] = hn::Sub(along(0), hn::Mul(hn::Load(rays, lines.shear[0] + i), z[c]));
      y[c] = hn::Sub(along(1), hn::Mul(hn::Load(rays, lines.shear[1] + i), z[c]));
    }
    for (std::size_t e = 0; e < 3; ++e) {
      const std::size_t p = (e + 1) % 3, q = (e + 2) % 3;
      edge[e] = hn::Sub(hn::Mul(x[p], y[q]), hn::Mul(y[p], x[q]));
    }
    const auto least = hn::Min(hn::Min(edge[0], edge[1]), edge[2]), zero = hn::Zero(rays);
    const auto most = hn::Max(hn::Max(edge[0], edge[1]), edge[2]);
    perhaps = hn::Or(hn::Ge(least, zero), hn::Le(most, zero));
    in_doubt = hn::And(perhaps, hn::Or(hn::Eq(least, zero), hn::Eq(most, zero)));
  }

  /// @param share  the barycentric coordinates
  /// @param t      of the hits
  /// @return which rays hit the triangle; those in doubt left out
  HWY_INLINE hn::Mask<Rays> hits(const SharedTriangle& triangle, const PacketLines& lines, std::size_t i,
                                 SomeRays* share, SomeRays& t) const {
    const auto determinant = hn::Add(hn::Add(edge[0], edge[1]), edge[2]);
    const auto scale = hn::Load(rays, lines.inverse[lines.axis[2]] + i);
    SomeRays part[3];
    for (std::size_t c = 0; c < 3; ++c) {
      share[c] = hn::Div(edge[c], determinant);
      part[c] = hn::Mul(share[c], hn::Mul(scale, z[c]));
    }
    const auto at = hn::Add(hn::Add(part[0], part[1]), part[2]);
    SomeRays lower, upper;
    for (std::size_t a = 0; a < 3; ++a) {
      // Of 0 and -0 the second argument is taken: the order of arguments is that of PreparedRay::through().
      const auto inverse = hn::Load(rays, lines.inverse[a] + i);
      const auto ahead = hn::Load(rays, lines.ahead[a] + i), behind = hn::Load(rays, lines.behind[a] + i);
      const auto one = hn::Mul(hn::Sub(hn::Set(rays, triangle.lower[a]), ahead), inverse);
      const auto other = hn::Mul(hn::Sub(hn::Set(rays, triangle.upper[a]), behind), inverse);
      const auto entry = hn::Min(one, other), exit = hn::Max(other, one);
      lower = a == 0 ? entry : hn::Max(entry, lower);
      upper = a == 0 ? exit : hn::Min(exit, upper);
    }
    t = hn::IfThenElse(hn::Lt(at, lower), lower, hn::IfThenElse(hn::Lt(upper, at), upper, at));
    const auto is_there = hn::And(hn::Le(lower, upper), hn::Eq(at, at));
    return hn::AndNot(in_doubt, hn::And(perhaps, is_there));
  }
};

/// The first hits of eight rays so far.
class FirstHits {
 public:
  HWY_INLINE FirstHits(const PacketQuery& query, const PacketLines& lines, PacketHits& hits)
      : query_(query), lines_(lines), hits_(hits) {
    for (std::size_t r = 0; r < PacketQuery::size; ++r) {
      limit_[r] = lines.number[7][r];
      hits.t[r] = 1.0 / 0.0;
      hits.triangle[r] = 4294967295.0;
      for (std::size_t c = 0; c < 3; ++c) hits.barycentric[c][r] = 0.0;
    }
  }

  /// Tests a triangle. @return whether a ray hits it, first so far
  HWY_INLINE bool test(const TriangleBlock& block, std::size_t lane) {
    const SharedTriangle triangle(block, lane, lines_);
    bool is_hit = false;
    for (std::size_t i = 0; i < PacketQuery::size; i += hn::Lanes(rays)) {
      const SeenByRays seen(triangle, lines_, i);
      if (hn::AllFalse(rays, seen.perhaps)) continue;
      if (query_.accepts != nullptr && !query_.accepts(query_.filter_context, triangle.id)) return is_hit;
      is_hit |= take(seen, triangle, i);
      for (std::uint32_t left = bits_of(rays, seen.in_doubt); left != 0;)
        is_hit |= take_in_doubt(block, lane, i + take_lowest(left));
    }
    return is_hit;
  }

  /// Nothing is wanted beyond this t.
  HWY_INLINE float upper() const {
    auto most = hn::Load(rays, limit_);
    for (std::size_t i = hn::Lanes(rays); i < PacketQuery::size; i += hn::Lanes(rays))
      most = hn::Max(most, hn::Load(rays, limit_ + i));
    return not_below(hn::GetLane(hn::MaxOfLanes(rays, most)));
  }

 private:
  HWY_INLINE bool take(const SeenByRays& seen, const SharedTriangle& triangle, std::size_t i) {
    SomeRays share[3], t;
    const auto hit = seen.hits(triangle, lines_, i, share, t);
    const auto id = hn::Set(rays, static_cast<double>(triangle.id));
    const auto best_t = hn::Load(rays, hits_.t + i), best_id = hn::Load(rays, hits_.triangle + i);
    const auto is_before = hn::Or(hn::Lt(t, best_t), hn::And(hn::Eq(t, best_t), hn::Lt(id, best_id)));
    const auto is_in_range =
        hn::And(hn::Ge(t, hn::Load(rays, lines_.number[6] + i)), hn::Le(t, hn::Load(rays, limit_ + i)));
    const auto is_first = hn::And(hit, hn::And(is_before, is_in_range));
    if (hn::AllFalse(rays, is_first)) return false;
    const auto set = [&](SomeRays value, double* place) HWY_ATTR {
      hn::Store(hn::IfThenElse(is_first, value, hn::Load(rays, place)), rays, place);
    };
    set(t, hits_.t + i);
    set(t, limit_ + i);
    set(id, hits_.triangle + i);
    for (std::size_t c = 0; c < 3; ++c) set(share[c], hits_.barycentric[c] + i);
    return true;
  }

  /// A ray and a triangle about which the routine itself has to be asked.
  bool take_in_doubt(const TriangleBlock& block, std::size_t lane, std::size_t r) {
    WideHit hit;
    if (!query_.decide(query_.context, block, lane, r, hit)) return false;
    if (!(hit.t >= lines_.number[6][r] && hit.t <= limit_[r])) return false;
    const auto id = static_cast<double>(block.id[lane]);
    if (!(hit.t < hits_.t[r] || (hit.t == hits_.t[r] && id < hits_.triangle[r]))) return false;
    hits_.t[r] = limit_[r] = hit.t;
    hits_.triangle[r] = id;
    for (std::size_t c = 0; c < 3; ++c) hits_.barycentric[c][r] = hit.barycentric[c];
    return true;
  }

  const PacketQuery& query_;
  const PacketLines& lines_;
  PacketHits& hits_;
  HWY_ALIGN double limit_[PacketQuery::size];
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif
