// The program `velum`: parses the command line, runs one verb, and turns what went wrong into a sentence and
// an exit code.
#include <algorithm>
#include <array>
#include <iostream>
#include <string>
#include <velum/velum.hpp>

#include "claims_command.hpp"
#include "ray_command.hpp"
#include "verb.hpp"

namespace {

using namespace velum_app;

constexpr const char* description =
    "velum turns a mesh file into a picture, under every projection, and shows each step of the way.";

constexpr const char* examples =
    "Examples:\n"
    "  velum render bunny.obj                          a picture bunny.png of the bunny\n"
    "  velum render builtin:house --projection cabinet -o house.png\n"
    "  velum matrix --projection isometric --point 0.5,0.5,0.5\n"
    "  velum info bunny.obj                            what is in the file\n"
    "  velum projections                               the catalogue of projections\n"
    "  velum pixel bunny.obj --at 400,300              why this pixel shows what it shows\n"
    "  velum clip-trace bunny.obj --triangle 7         how the view volume cuts a triangle\n"
    "  velum pyramid bunny.obj -o levels               what the z-pyramid knows, level by level\n"
    "  velum diff before.png after.png                 how far two pictures are apart\n"
    "  velum agree bunny.obj                           what rays see, against what the raster sees\n"
    "  velum ray bunny.obj --pixel 400,300 --traversal a ray's way through the boxes\n"
    "  velum claims                                    what the lectures claim, tested, as a page\n"
    "`velum VERB --help` tells more. Exit codes: 0 ok, 1 nothing to be seen, or pictures differ,\n"
    "2 usage, 3 cannot read, 4 cannot write.";

int exit_code_of(velum::ErrorKind kind) {
  switch (kind) {
    case velum::ErrorKind::read:
      return exit_cannot_read;
    case velum::ErrorKind::write:
      return exit_cannot_write;
    case velum::ErrorKind::usage:
    case velum::ErrorKind::limit:
    case velum::ErrorKind::cancelled:
      break;
  }
  return exit_usage;
}

int complain(const std::string& message, int code) {
  std::cerr << "velum: " << message << '\n';
  return code;
}

/// Help and version end with 0; everything else that the parser refuses is a mistake of usage.
int report_parse_error(const CLI::App& program, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return program.exit(error);
  return complain(std::string(error.what()) + "; see velum --help", exit_usage);
}

int run(int argc, char** argv) {
  CLI::App program(description, "velum");
  program.footer(examples);
  program.set_version_flag("--version", "velum " VELUM_VERSION);
  program.require_subcommand(1);
  const std::array verbs{add_render(program),      add_matrix(program), add_info(program),
                         add_projections(program), add_views(program),  add_pixel(program),
                         add_clip_trace(program),  add_diff(program),   add_agree(program),
                         add_pyramid(program),     add_ray(program),    add_claims(program)};
  if (argc < 2) {
    std::cerr << program.help();
    return exit_usage;
  }
  const bool names_a_verb = std::any_of(
      verbs.begin(), verbs.end(), [argv](const Verb& verb) { return verb.parser->get_name() == argv[1]; });
  if (argv[1][0] != '-' && !names_a_verb) {
    return complain("there is no verb \"" + std::string(argv[1]) + "\"; see velum --help", exit_usage);
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report_parse_error(program, error);
  }
  for (const Verb& verb : verbs) {
    if (*verb.parser) return verb.run();
  }
  return exit_usage;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int code = run(argc, argv);
    std::cout.flush();
    if (!std::cout) return complain("standard output cannot be written", exit_cannot_write);
    return code;
  } catch (const velum::Error& error) {
    return complain(error.what(), exit_code_of(error.kind()));
  } catch (const std::bad_alloc&) {
    return complain("not enough memory; try a smaller --size", exit_usage);
  } catch (const std::exception& error) {
    return complain(std::string("internal error, please report it: ") + error.what(), exit_internal);
  }
}
