// velum projections: the catalogue.
#include <iostream>
#include <memory>
#include <velum/velum.hpp>

#include "json_values.hpp"
#include "text.hpp"
#include "verb.hpp"

namespace velum_app {
namespace {

using namespace velum;

constexpr const char* footer =
    "Examples:\n"
    "  velum projections\n"
    "  velum render builtin:house --projection oblique:angle=30,scale=0.5";

std::string value_text(const ProjectionEntry::Parameter& parameter) {
  return number_text(parameter.default_value, 6) + (parameter.unit == "degrees" ? "°" : "");
}

void print_entry(const ProjectionEntry& entry) {
  std::cout << "  " << padded_right(std::string(entry.name), 16) << "  " << entry.summary << '\n';
  for (const auto& parameter : entry.parameters) {
    std::cout << "                      " << parameter.name << " = " << value_text(parameter) << ": "
              << parameter.meaning << '\n';
  }
}

void print_text() {
  std::string_view family;
  for (const ProjectionEntry& entry : projection_catalogue()) {
    if (entry.family != family) std::cout << (family.empty() ? "" : "\n") << entry.family << '\n';
    family = entry.family;
    print_entry(entry);
  }
  std::cout << "\nUse: --projection NAME or --projection NAME:parameter=value,parameter=value\n";
}

Json entry_json(const ProjectionEntry& entry) {
  Json parameters = Json::array();
  for (const auto& parameter : entry.parameters) {
    parameters.push_back({{"name", parameter.name},
                          {"unit", parameter.unit},
                          {"default", parameter.default_value},
                          {"meaning", parameter.meaning}});
  }
  return {{"name", entry.name},
          {"family", entry.family},
          {"summary", entry.summary},
          {"source", entry.source},
          {"parameters", parameters}};
}

int run(bool json) {
  if (!json) {
    print_text();
    return exit_ok;
  }
  Json list = Json::array();
  for (const ProjectionEntry& entry : projection_catalogue()) list.push_back(entry_json(entry));
  std::cout << json_text(list);
  return exit_ok;
}

}  // namespace

Verb add_projections(CLI::App& program) {
  CLI::App* parser = program.add_subcommand("projections", "List the projections and their parameters");
  const auto json = std::make_shared<bool>(false);
  parser->add_flag("--json", *json, "Print JSON");
  parser->footer(footer);
  return {parser, [json] { return run(*json); }};
}

}  // namespace velum_app
