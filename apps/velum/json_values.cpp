#include "json_values.hpp"

#include <algorithm>
#include <variant>

namespace velum_app {

using namespace velum;

namespace {

/// An array of plain values stands on one line, so that a matrix looks like one.
bool fits_on_a_line(const Json& json) {
  if (json.is_object()) return json.empty();
  return std::none_of(json.begin(), json.end(), [](const Json& item) { return item.is_structured(); });
}

std::string indented(const Json& json, std::size_t depth) {
  if (!json.is_structured() || fits_on_a_line(json)) return json.dump();
  const std::string margin(2 * depth + 2, ' ');
  std::string text;
  for (const auto& [key, value] : json.items()) {
    text += (text.empty() ? "" : ",\n") + margin;
    if (json.is_object()) text += Json(key).dump() + ": ";
    text += indented(value, depth + 1);
  }
  text = "\n" + text + "\n" + std::string(2 * depth, ' ');
  return json.is_object() ? "{" + text + "}" : "[" + text + "]";
}

}  // namespace

Json json_of(const glm::dvec3& vector) {
  return Json::array({vector.x, vector.y, vector.z});
}

Json json_of(const glm::dvec4& vector) {
  return Json::array({vector.x, vector.y, vector.z, vector.w});
}

Json json_of(const glm::dmat4& matrix) {
  Json rows = Json::array();
  for (int row = 0; row < 4; ++row) {
    rows.push_back({matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]});
  }
  return rows;
}

Json json_of(const StageList& stages) {
  Json list = Json::array();
  for (const Stage& stage : stages) {
    list.push_back({{"name", std::string(stage.name)},
                    {"meaning", std::string(stage.meaning)},
                    {"matrix", json_of(stage.matrix)}});
  }
  return list;
}

Json json_of(const Camera& camera) {
  const Pose& pose = camera.pose();
  Json json{{"eye", json_of(pose.position)},
            {"look", json_of(pose.look)},
            {"up", json_of(pose.up)},
            {"near", camera.near()},
            {"far", camera.far()}};
  if (const auto* lens = std::get_if<PerspectiveLens>(&camera.lens())) {
    json["lens"] = "perspective";
    json["shift"] = {lens->shift.x, lens->shift.y};
    if (const auto* angle = std::get_if<VerticalAngle>(&lens->opening)) {
      json["vertical_angle_degrees"] = degrees(angle->radians);
    } else if (const auto* wide = std::get_if<HorizontalAngle>(&lens->opening)) {
      json["horizontal_angle_degrees"] = degrees(wide->radians);
    }
  } else if (const auto* window = std::get_if<ParallelWindow>(&camera.lens())) {
    json["lens"] = "parallel";
    json["window_height"] = window->height;
    json["shear"] = {window->shear.x, window->shear.y};
  }
  return json;
}

std::string json_text(const Json& json) {
  return indented(json, 0) + "\n";
}

}  // namespace velum_app
