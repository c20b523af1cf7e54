// Prints one line per scene and buffer, "name sha256": what the hash matrix compares between compilers, build
// types, instruction sets and callers.
//
//   --ftz     flush denormals to zero before calling velum, as a careless caller may have done
//   --locale  switch to a locale that writes numbers with a comma

#include <nettle/sha2.h>

#include <clocale>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <locale>
#include <string>
#include <velum/velum.hpp>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace {

std::string sha256(const void* data, std::size_t size) {
  sha256_ctx context;
  sha256_init(&context);
  sha256_update(&context, size, static_cast<const std::uint8_t*>(data));
  std::uint8_t digest[SHA256_DIGEST_SIZE];
  sha256_digest(&context, sizeof digest, digest);
  std::string text;
  for (const std::uint8_t byte : digest) {
    constexpr char digits[] = "0123456789abcdef";
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

void print_hash(const std::string& name, const void* data, std::size_t size) {
  std::printf("%s %s\n", name.c_str(), sha256(data, size).c_str());
}

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
  print_hash("nothing", "", 0);
}
