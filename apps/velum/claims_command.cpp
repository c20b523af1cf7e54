// velum claims [IN...]: what the lectures claim, tested on scenes, as a page.
#include "claims_command.hpp"

#include <claim.hpp>
#include <iostream>
#include <memory>
#include <span>
#include <velum/velum.hpp>

#include "input.hpp"
#include "outputs.hpp"

namespace velum_app {
namespace {

using namespace velum;

struct ClaimsOptions {
  std::vector<std::string> inputs;
  std::string output = "claims.html";
  bool quick = false;
  bool quiet = false;
};

constexpr const char* footer =
    "Each claim is given with its formula, figures and a verdict: holds, or does not hold here. Without IN,\n"
    "built-in shapes are measured. It takes about a minute.\n"
    "Examples:\n"
    "  velum claims                                      claims.html\n"
    "  velum claims bunny.obj castle.ply -o claims.html";

int run(const ClaimsOptions& o) {
  check_outputs({{OutputKind::page, "-o", o.output}});
  std::vector<velum_claims::Subject> subjects;
  for (const std::string& input : o.inputs) {
    subjects.push_back(velum_claims::subject_of(stem_of(input), read_scene(input)));
  }
  if (subjects.empty()) subjects = velum_claims::built_in_subjects(o.quick);
  const auto tell = [&](const std::string& title) {
    if (!o.quiet) std::cerr << title << " ...\n";
  };
  const std::vector<velum_claims::Claim> claims = velum_claims::test_claims(subjects, {o.quick}, tell);
  const std::string page = velum_claims::page_of(claims, subjects);
  write_file(o.output, std::as_bytes(std::span(page)));
  if (o.quiet || o.output == "-") return exit_ok;
  for (const velum_claims::Claim& claim : claims) {
    std::cout << velum_claims::name_of(claim.verdict) << ": " << claim.title << "\n    " << claim.reason
              << '\n';
  }
  std::cout << o.output << ": written\n";
  return exit_ok;
}

}  // namespace

Verb add_claims(CLI::App& program) {
  CLI::App* parser =
      program.add_subcommand("claims", "Test what the lectures claim, and write a page with plots");
  const auto options = std::make_shared<ClaimsOptions>();
  parser->add_option("IN", options->inputs, input_help)->type_name("");
  parser->add_option("-o,--output", options->output, "The page; claims.html if not given")
      ->type_name("FILE.html");
  parser->add_flag("--quick", options->quick, "Small scenes and few rays: a few seconds, rough figures");
  parser->add_flag("--quiet", options->quiet, "Say nothing but errors");
  parser->footer(footer);
  return {parser, [options] { return run(*options); }};
}

}  // namespace velum_app
