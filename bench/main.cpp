// velum-bench: how long a frame takes, scene by scene, with llvmpipe beside it in turn.
#include <cstdio>
#include <exception>

#include "llvmpipe.hpp"
#include "tasks.hpp"

namespace {

using namespace velum_bench;

/// The child's part of memory_in_child().
int print_memory_here(const Options& options) {
  const auto bytes = memory_here(options.scenes.at(0), options.modes.at(0), options.measure);
  if (!bytes) return 1;
  std::printf("%llu\n", static_cast<unsigned long long>(*bytes));
  return 0;
}

int run(const Options& options) {
  set_llvmpipe_threads(options.measure.velum.threads);
  if (options.is_memory_here) return print_memory_here(options);
  if (options.is_limits) return run_limits(options);
  if (options.is_growth) return run_growth(options);
  if (options.is_rays) return run_rays(options);
  if (options.is_check) return run_check(options);
  return run_frames(options);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const ParsedOptions parsed = parse_options(argc, argv);
    return parsed.options ? run(*parsed.options) : parsed.exit_code;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "velum-bench: %s\n", error.what());
    return 1;
  }
}
