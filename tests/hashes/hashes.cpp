// Prints one line per picture of the golden table, its name and the SHA-256 of each buffer: what the hash
// matrix compares between compilers, build types, instruction sets and callers.
//
//   --ftz     flush denormals to zero before calling velum, as a careless caller may have done
//   --locale  switch to a locale that writes numbers with a comma

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <locale>

#include "fingerprint.hpp"
#include "scenes.hpp"

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace {

void flush_denormals_to_zero() {
#ifdef __SSE2__
  constexpr unsigned flush_to_zero = 0x8000;
  constexpr unsigned denormals_are_zero = 0x0040;
  _mm_setcsr(_mm_getcsr() | flush_to_zero | denormals_are_zero);
#endif
}

void use_comma_locale() {
  const char* name = "de_DE.UTF-8";
  if (std::setlocale(LC_ALL, name) == nullptr || std::strcmp(std::localeconv()->decimal_point, ",") != 0) {
    std::fprintf(stderr, "velum_hashes: the locale %s is not there or writes no comma; set LOCPATH\n", name);
    std::exit(2);
  }
  std::locale::global(std::locale(name));
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--ftz") == 0) {
      flush_denormals_to_zero();
    } else if (std::strcmp(argv[i], "--locale") == 0) {
      use_comma_locale();
    } else {
      std::fprintf(stderr, "velum_hashes: unknown option %s\n", argv[i]);
      return 2;
    }
  }
  const std::vector<golden::GoldenScene> scenes = golden::golden_scenes();
  for (const golden::GoldenPicture& picture : golden::golden_pictures(scenes)) {
    const velum::Picture rendered = picture.render(golden::golden_modes().front());
    std::printf("%s %s\n", picture.name().c_str(), golden::fingerprint(rendered).c_str());
  }
}
