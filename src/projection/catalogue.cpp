#include "catalogue.hpp"

#include <cmath>

#include "../base/error.hpp"

namespace velum {
namespace {

using Parameter = ProjectionEntry::Parameter;
using Maker = Projection (*)(const ParameterValues&);

struct Row {
  ProjectionEntry entry;
  Maker make;
};

constexpr std::string_view iso2 = "ISO 5456-2:1996";
constexpr std::string_view iso3 = "ISO 5456-3:1996";
constexpr std::string_view lecture = "lecture \"Projektionen und Sichtbarkeit\"";

constexpr Parameter angle{"angle", "degrees", 45.0,
                          "direction in which a receding axis is drawn, from the right"};
constexpr Parameter alpha{"alpha", "degrees", 63.434948822922,
                          "instead of scale: angle between projectors and picture plane, scale = cot(alpha)"};
constexpr Parameter fov{"fov", "degrees", 40.0, "vertical opening angle"};

constexpr Parameter scale(double value) {
  return {"scale", "ratio", value, "length of a receding unit edge on the picture"};
}
constexpr Parameter elevation(double value) {
  return {"elevation", "degrees", value, "height of the camera above the horizon"};
}
constexpr Parameter azimuth(double value) {
  return {"azimuth", "degrees", value, "direction to the camera, from the front towards the right"};
}

Projection oblique_by_scale_or_alpha(const ParameterValues& values) {
  if (!values.given[2]) return projection::oblique(values[0], values[1]);
  if (values.given[1]) {
    throw Error(ErrorKind::usage, "both scale and alpha are given", "oblique",
                "scale = cot(alpha), so one of them is enough");
  }
  const double slant = *values.given[2];
  if (!(slant > 0.0 && slant <= 0.5 * pi + 1e-12)) {
    throw Error(ErrorKind::usage, "the projectors do not reach the picture plane from the front",
                "oblique:alpha", "it must be greater than 0 and at most 90 degrees");
  }
  return projection::oblique(values[0], std::abs(elementary::cos(slant)) / elementary::sin(slant));
}

std::vector<Row> orthographic_rows() {
  using V = ParameterValues;
  return {
      {{"front", "orthographic", "Seen from the front: x to the right, y up.", iso2, {}},
       [](const V&) { return projection::front(); }},
      {{"back", "orthographic", "Seen from behind.", iso2, {}}, [](const V&) { return projection::back(); }},
      {{"left", "orthographic", "Seen from the left side.", iso2, {}},
       [](const V&) { return projection::left(); }},
      {{"right", "orthographic", "Seen from the right side.", iso2, {}},
       [](const V&) { return projection::right(); }},
      {{"top", "orthographic", "Seen from above: the plan.", iso2, {}},
       [](const V&) { return projection::top(); }},
      {{"bottom", "orthographic", "Seen from below.", iso2, {}},
       [](const V&) { return projection::bottom(); }},
      {{"isometric", "orthographic", "All three axes equally shortened, 120 degrees apart.", iso3, {}},
       [](const V&) { return projection::isometric(); }},
      {{"dimetric",
        "orthographic",
        "Width and height equally shortened, depth drawn half as long as they.",
        "derived; ISO 5456-3:1996 rounds its angles to 7 and 42 degrees",
        {}},
       [](const V&) { return projection::dimetric(); }},
      {{"dimetric-2to1",
        "orthographic",
        "Both ground axes fall one pixel in two: the view of pixel art.",
        "derived: elevation 30, azimuth 45 degrees",
        {}},
       [](const V&) { return projection::dimetric_2to1(); }},
      {{"trimetric",
        "orthographic",
        "Three different shortenings: seen from any elevation and azimuth.",
        lecture,
        {elevation(35.0), azimuth(30.0)}},
       [](const V& v) { return projection::trimetric(v[0], v[1]); }},
  };
}

std::vector<Row> oblique_rows() {
  using V = ParameterValues;
  return {
      {{"axonometry",
        "axonometry",
        "Any parallel picture of three axes, by their angles and scales.",
        "Pohlke 1853",
        {{"x", "degrees", -7.0, "direction of the x axis on the picture, counter-clockwise from the right"},
         {"y", "degrees", 90.0, "direction of the y axis"},
         {"z", "degrees", 222.0, "direction of the z axis"},
         {"sx", "ratio", 1.0, "length of the x unit on the picture"},
         {"sy", "ratio", 1.0, "length of the y unit"},
         {"sz", "ratio", 0.5, "length of the z unit"}}},
       [](const V& v) {
         return projection::axonometry({v[0], v[1], v[2]}, {v[3], v[4], v[5]});
       }},
      {{"cavalier",
        "oblique",
        "Front face true, receding edges at full length.",
        lecture,
        {angle, scale(1.0)}},
       [](const V& v) { return projection::cavalier(v[0], v[1]); }},
      {{"cabinet",
        "oblique",
        "Front face true, receding edges at half length.",
        lecture,
        {angle, scale(0.5)}},
       [](const V& v) { return projection::cabinet(v[0], v[1]); }},
      {{"natural-oblique",
        "oblique",
        "Front face true, receding edges at two thirds.",
        lecture,
        {angle, scale(2.0 / 3.0)}},
       [](const V& v) { return projection::natural_oblique(v[0], v[1]); }},
      {{"military",
        "oblique",
        "Plan true and turned, heights drawn straight up.",
        iso3,
        {{"turn", "degrees", 45.0, "how far the plan is turned"}, scale(1.0)}},
       [](const V& v) { return projection::military(v[0], v[1]); }},
      {{"oblique",
        "oblique",
        "Front face true, receding edges at any angle and scale.",
        lecture,
        {angle, scale(0.5), alpha}},
       oblique_by_scale_or_alpha},
  };
}

std::vector<Row> perspective_rows() {
  using V = ParameterValues;
  return {
      {{"perspective",
        "perspective",
        "As an eye or a camera sees it.",
        lecture,
        {fov, elevation(20.0), azimuth(30.0)}},
       [](const V& v) { return projection::perspective(v[0], v[1], v[2]); }},
      {{"one-point",
        "perspective",
        "Front faces stay parallel to the picture; only depth converges.",
        lecture,
        {fov, elevation(20.0), azimuth(25.0)}},
       [](const V& v) { return projection::one_point(v[0], v[1], v[2]); }},
      {{"two-point",
        "perspective",
        "Verticals stay vertical; both horizontal axes converge.",
        lecture,
        {fov, elevation(20.0), azimuth(35.0)}},
       [](const V& v) { return projection::two_point(v[0], v[1], v[2]); }},
      {{"three-point",
        "perspective",
        "All three axes converge.",
        lecture,
        {fov, elevation(30.0), azimuth(35.0)}},
       [](const V& v) { return projection::three_point(v[0], v[1], v[2]); }},
  };
}

std::vector<Row> all_rows() {
  std::vector<Row> rows = orthographic_rows();
  for (const std::vector<Row>& more : {oblique_rows(), perspective_rows()}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

const std::vector<Row>& catalogue_rows() {
  static const std::vector<Row> rows = all_rows();
  return rows;
}

std::vector<ProjectionEntry> all_entries() {
  std::vector<ProjectionEntry> entries;
  for (const Row& row : catalogue_rows()) entries.push_back(row.entry);
  return entries;
}

}  // namespace

const std::vector<ProjectionEntry>& projection_catalogue() {
  static const std::vector<ProjectionEntry> entries = all_entries();
  return entries;
}

double in_api_unit(const Parameter& parameter, double value) {
  return parameter.unit == "degrees" ? radians(value) : value;
}

double ParameterValues::operator[](std::size_t index) const {
  const Parameter& parameter = entry->parameters[index];
  return given[index].value_or(in_api_unit(parameter, parameter.default_value));
}

Projection make_projection(std::size_t index, const ParameterValues& values) {
  return catalogue_rows()[index].make(values);
}

}  // namespace velum
