#include "surface_rows.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/lighting_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's header is read anew for every target; it must follow the line above.
#include <hwy/highway.h>

#include "../base/elementary_vectors.hpp"
#include "../base/simd_dispatch.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

using namespace elementary_vectors;
using Floats = hn::Rebind<float, Doubles>;
using Float = hn::Vec<Floats>;
using Mask = hn::Mask<Doubles>;
constexpr Floats floats;

struct Direction {
  Double x, y, z;
};

HWY_INLINE Double dot(const Direction& a, const Direction& b) {
  return sum(sum(product(a.x, b.x), product(a.y, b.y)), product(a.z, b.z));
}

/// unit() of lighting.cpp: v / |v|; zero for zero.
HWY_INLINE Direction unit(const Direction& v) {
  const Double length = hn::Sqrt(dot(v, v));
  const Mask has_length = hn::Gt(length, hn::Zero(doubles));
  return {hn::IfThenElseZero(has_length, hn::Div(v.x, length)),
          hn::IfThenElseZero(has_length, hn::Div(v.y, length)),
          hn::IfThenElseZero(has_length, hn::Div(v.z, length))};
}

/// The surface under one vector of pixels.
struct Surface {
  Direction position;
  Direction normal;
  Direction to_viewer;
  Float base[3];
};

HWY_INLINE Surface surface_at(const SurfaceRow& row, std::size_t i) {
  const auto places = [&](const double(&plane)[row_room]) { return hn::LoadU(doubles, plane + i); };
  const auto colours = [&](const float(&plane)[row_room]) { return hn::LoadU(floats, plane + i); };
  const auto normals = [&](const float(&plane)[row_room]) {
    return hn::PromoteTo(doubles, hn::LoadU(floats, plane + i));
  };
  return {{places(row.position[0]), places(row.position[1]), places(row.position[2])},
          {normals(row.normal[0]), normals(row.normal[1]), normals(row.normal[2])},
          {places(row.to_viewer[0]), places(row.to_viewer[1]), places(row.to_viewer[2])},
          {colours(row.colour[0]), colours(row.colour[1]), colours(row.colour[2])}};
}

HWY_INLINE Direction towards(const RowLight& light, const Surface& surface) {
  const Direction at = {all(light.towards[0]), all(light.towards[1]), all(light.towards[2])};
  if (!light.is_place) return at;
  return unit({difference(at.x, surface.position.x), difference(at.y, surface.position.y),
               difference(at.z, surface.position.z)});
}

HWY_INLINE hn::Mask<Floats> in_floats(Mask where) {
  const Float ones = hn::DemoteTo(floats, hn::IfThenElseZero(where, all(1.0)));
  return hn::Gt(ones, hn::Zero(floats));
}

HWY_INLINE bool is_shiny(const LightingWork& work) {
  return !(work.specular[0] == 0.0f && work.specular[1] == 0.0f && work.specular[2] == 0.0f);
}

/// The highlight's strength where the surface is lit and the half vector before it; elsewhere nothing.
struct Highlight {
  Mask where;
  Float strength;
};
HWY_INLINE Highlight highlight_of(const LightingWork& work, const Surface& surface, const Direction& to_light,
                                  Mask is_lit) {
  const Direction half = unit({sum(to_light.x, surface.to_viewer.x), sum(to_light.y, surface.to_viewer.y),
                               sum(to_light.z, surface.to_viewer.z)});
  const Double one = all(1.0);
  const Double n_h = dot(surface.normal, half);
  const Mask where = hn::And(is_lit, hn::Gt(n_h, hn::Zero(doubles)));
  if (hn::AllFalse(doubles, where)) return {where, hn::Zero(floats)};
  const Double cosine = hn::IfThenElse(hn::And(where, hn::Le(n_h, one)), n_h, one);
  return {where, hn::DemoteTo(floats, elementary_vectors::pow(cosine, all(work.shininess)))};
}

/// Adds what one light brings: reflected() of lighting.cpp, operation for operation.
HWY_INLINE void add_light(const LightingWork& work, const RowLight& light, const Surface& surface,
                          Float (&colour)[3]) {
  const Direction to_light = towards(light, surface);
  const Double n_l = dot(surface.normal, to_light);
  const Mask is_lit = hn::Gt(n_l, hn::Zero(doubles));
  const Float strength = hn::DemoteTo(floats, hn::IfThenElseZero(is_lit, n_l));
  Float reflected[3];
  for (int c = 0; c < 3; ++c)
    reflected[c] = hn::Mul(hn::Mul(hn::Set(floats, work.diffuse[c]), surface.base[c]), strength);
  if (is_shiny(work) && !hn::AllFalse(doubles, is_lit)) {
    const Highlight highlight = highlight_of(work, surface, to_light, is_lit);
    const auto where = in_floats(highlight.where);
    for (int c = 0; c < 3; ++c) {
      const Float shine = hn::Mul(hn::Set(floats, work.specular[c]), highlight.strength);
      reflected[c] = hn::IfThenElse(where, hn::Add(reflected[c], shine), reflected[c]);
    }
  }
  const auto lit = in_floats(is_lit);
  for (int c = 0; c < 3; ++c) {
    const Float seen = hn::IfThenElseZero(lit, reflected[c]);
    colour[c] = hn::Add(colour[c], hn::Mul(hn::Set(floats, light.radiance[c]), seen));
  }
}

}  // namespace

void light_row(const LightingWork& work) {
  SurfaceRow& row = *work.row;
  for (std::size_t i = work.begin; i < work.end; i += hn::Lanes(doubles)) {
    const Surface surface = surface_at(row, i);
    Float colour[3];
    for (int c = 0; c < 3; ++c) colour[c] = hn::Mul(hn::Set(floats, work.ambient[c]), surface.base[c]);
    for (std::size_t light = 0; light < work.light_count; ++light)
      add_light(work, work.lights[light], surface, colour);
    const std::size_t left = work.end - i;
    for (int c = 0; c < 3; ++c)
      hn::BlendedStore(colour[c], hn::FirstN(floats, left), floats, row.colour[c] + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

LightRow light_row_kernel(Isa isa) {
  static constexpr auto versions = VELUM_KERNEL_VERSIONS(light_row);
  return versions.at(isa);
}

}  // namespace velum
#endif
