#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdlib>

// Runs the tests of one module. Tests named "[long] …" are left out unless VELUM_LONG_TESTS is set.
int main(int argc, char** argv) {
  doctest::Context context;
  if (std::getenv("VELUM_LONG_TESTS") == nullptr) context.addFilter("test-case-exclude", "[long]*");
  context.applyCommandLine(argc, argv);
  return context.run();
}
