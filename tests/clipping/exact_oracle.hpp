#pragma once

#include <array>
#include <cstdint>
#include <vector>

/// Whether a triangle or a segment meets the view volume, decided in exact integers by brute force and
/// without any clipping: in barycentric coordinates the visible part is where six (one per plane) and three
/// (λ ≥ 0) linear forms are ≥ 0, a cone whose extreme rays are among the cross products of pairs of the
/// forms.
namespace exact {

using Point = std::array<std::int64_t, 4>;  ///< |coordinate| ≤ 1000: all products stay below 2^63
using Form = std::array<std::int64_t, 3>;   ///< a linear form in the barycentric coordinates

enum class Meeting { apart, touching, overlapping };

/// The six signed values of a point, written out plane by plane on purpose (the library has a table).
inline std::array<std::int64_t, 6> signed_values(const Point& p) {
  return {p[2], p[3] - p[2], p[3] + p[0], p[3] - p[0], p[3] + p[1], p[3] - p[1]};
}

inline Form cross(const Form& a, const Form& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline std::int64_t dot(const Form& a, const Form& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline bool zero(const Form& a) {
  return a == Form{0, 0, 0};
}

/// Adds the ray to the sum if it satisfies all forms; returns whether it does.
inline bool add_if_inside(const std::vector<Form>& forms, const Form& ray, Form& sum) {
  if (zero(ray)) return false;
  for (const Form& form : forms) {
    if (dot(form, ray) < 0) return false;
  }
  for (unsigned i = 0; i < 3; ++i) sum[i] += ray[i];
  return true;
}

/// overlapping: the common part has an interior within the triangle; touching: less than that.
inline Meeting meeting(const std::array<Point, 3>& triangle) {
  std::vector<Form> forms{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (unsigned plane = 0; plane < 6; ++plane) {
    Form form;
    for (unsigned i = 0; i < 3; ++i) form[i] = signed_values(triangle[i])[plane];
    if (!zero(form)) forms.push_back(form);
  }
  bool any = false;
  Form sum{0, 0, 0};
  for (std::size_t i = 0; i < forms.size(); ++i) {
    for (std::size_t j = i + 1; j < forms.size(); ++j) {
      const Form ray = cross(forms[i], forms[j]);
      any = add_if_inside(forms, ray, sum) || any;
      any = add_if_inside(forms, {-ray[0], -ray[1], -ray[2]}, sum) || any;
    }
  }
  if (!any) return Meeting::apart;
  // The sum of all extreme rays is in the interior if there is one.
  for (const Form& form : forms) {
    if (dot(form, sum) == 0) return Meeting::touching;
  }
  return Meeting::overlapping;
}

/// A fraction with positive denominator.
struct Fraction {
  std::int64_t numerator;
  std::int64_t denominator;
};

inline bool less(const Fraction& a, const Fraction& b) {
  return a.numerator * b.denominator < b.numerator * a.denominator;
}

struct Interval {
  Fraction t0{0, 1};
  Fraction t1{1, 1};
  bool empty = false;
};

/// Liang & Barsky 1984 in exact fractions: the part of a + t·(b - a), 0 ≤ t ≤ 1, inside the volume.
inline Interval interval(const Point& a, const Point& b) {
  Interval visible;
  for (unsigned plane = 0; plane < 6; ++plane) {
    const std::int64_t da = signed_values(a)[plane];
    const std::int64_t db = signed_values(b)[plane];
    if (da < 0 && db < 0) visible.empty = true;
    if (da < 0 && db >= 0 && less(visible.t0, {-da, db - da})) visible.t0 = {-da, db - da};
    if (da >= 0 && db < 0 && less({da, da - db}, visible.t1)) visible.t1 = {da, da - db};
  }
  visible.empty = visible.empty || less(visible.t1, visible.t0);
  return visible;
}

/// Whether the vectors are linearly dependent: the triangle passes through the eye edge-on or is degenerate.
inline bool dependent(const std::array<Point, 3>& triangle) {
  for (unsigned left_out = 0; left_out < 4; ++left_out) {
    std::array<Form, 3> rows;
    for (unsigned i = 0; i < 3; ++i) {
      unsigned column = 0;
      for (unsigned axis = 0; axis < 4; ++axis) {
        if (axis != left_out) rows[i][column++] = triangle[i][axis];
      }
    }
    if (dot(rows[0], cross(rows[1], rows[2])) != 0) return false;
  }
  return true;
}

inline bool dependent(const Point& a, const Point& b) {
  for (unsigned i = 0; i < 4; ++i) {
    for (unsigned j = i + 1; j < 4; ++j) {
      if (a[i] * b[j] != a[j] * b[i]) return false;
    }
  }
  return true;
}

}  // namespace exact
