#include <fast_float/fast_float.h>

#include <cmath>

#include "../base/error.hpp"
#include "../base/floating_point.hpp"
#include "catalogue.hpp"

namespace velum {
namespace {

std::string quoted(std::string_view text) {
  return "\"" + std::string(text) + "\"";
}

template <typename Range>
std::string names_of(const Range& rows) {
  std::string names;
  for (const auto& row : rows) names += (names.empty() ? "" : ", ") + std::string(row.name);
  return names;
}

template <typename Range>
std::optional<std::size_t> find_name(const Range& rows, std::string_view name) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].name == name) return i;
  }
  return {};
}

// Takes the part before the separator off the front of `rest`.
std::string_view next_part(std::string_view& rest, char separator) {
  const std::size_t end = rest.find(separator);
  const std::string_view part = rest.substr(0, end);
  rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  return part;
}

double parse_number(std::string_view text, const std::string& where) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto result = fast_float::from_chars(text.data(), end, value);
  if (text.empty() || result.ec != std::errc() || result.ptr != end || !std::isfinite(value)) {
    throw Error(ErrorKind::usage, quoted(text) + " is not a number", where, "write for example 45 or 0.5");
  }
  return value;
}

void parse_setting(std::string_view setting, ParameterValues& values) {
  const ProjectionEntry& entry = *values.entry;
  const std::string name(entry.name);
  const std::size_t equals = setting.find('=');
  const std::string_view key = setting.substr(0, equals);
  const std::optional<std::size_t> index = find_name(entry.parameters, key);
  if (!index) {
    throw Error(
        ErrorKind::usage, "there is no parameter " + quoted(key), name,
        entry.parameters.empty() ? "it takes no parameters" : "it takes " + names_of(entry.parameters));
  }
  const std::string where = name + ":" + std::string(key);
  if (equals == std::string_view::npos) {
    throw Error(ErrorKind::usage, "the value is missing", where, "write " + std::string(key) + "=NUMBER");
  }
  if (values.given[*index]) throw Error(ErrorKind::usage, "the parameter is given twice", where);
  const double number = parse_number(setting.substr(equals + 1), where);
  values.given[*index] = in_api_unit(entry.parameters[*index], number);
}

}  // namespace

Projection parse_projection(std::string_view text) {
  const FloatingPointScope floating_point;
  const std::vector<ProjectionEntry>& catalogue = projection_catalogue();
  std::string_view settings = text;
  const std::string_view name = next_part(settings, ':');
  const std::optional<std::size_t> index = find_name(catalogue, name);
  if (!index) {
    throw Error(ErrorKind::usage, "there is no projection " + quoted(name), "projection",
                "the projections are " + names_of(catalogue));
  }
  const ProjectionEntry& entry = catalogue[*index];
  ParameterValues values{&entry, std::vector<std::optional<double>>(entry.parameters.size())};
  if (text.size() > name.size() && (settings.empty() || settings.back() == ',')) {
    throw Error(ErrorKind::usage, "a parameter is missing after " + quoted(text.substr(text.size() - 1)),
                std::string(name), "write " + std::string(name) + ":KEY=NUMBER,KEY=NUMBER");
  }
  while (!settings.empty()) parse_setting(next_part(settings, ','), values);
  return make_projection(*index, values);
}

}  // namespace velum
