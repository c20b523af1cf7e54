#!/bin/sh
# Demands that matrix.sh refuses a program whose bytes depend on libm, on FTZ, on the locale, or on the compiler's
# optimization, and that a missing hashes.txt fails. The planted programs stand in for velum_hashes in a small tree.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir -p "$tree/tests/hashes"
cat >"$tree/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.24)
project(planted LANGUAGES CXX)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
add_executable(velum_hashes planted.cpp)
END

matrix() { VELUM_HASHES_VARIANTS='g++-Release g++-Debug' "$here/matrix.sh" "$tree" "$tree/build" >"$tree/log" 2>&1; }

# plant BODY: the main function of the stand-in; `ftz` and `comma` tell what the caller did
plant() {
  cat >"$tree/planted.cpp" <<END
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstring>
int main(int argc, char** argv) {
  const bool ftz = argc > 1 && std::strcmp(argv[1], "--ftz") == 0;
  if (argc > 1 && !ftz) std::setlocale(LC_ALL, "de_DE.UTF-8");
  volatile double sum = ftz ? 1.0 : 0.0;
  (void)sum;
  $1
}
END
}

# Takes what the stand-in prints for the committed hashes.
commit() { g++ -O3 -o "$tree/planted" "$tree/planted.cpp" && "$tree/planted" >"$tree/tests/hashes/hashes.txt"; }

must_fail() { # WHAT TEXT
  if matrix || ! grep -q -F "$2" "$tree/log"; then
    echo "matrix.sh does not refuse $1:"
    cat "$tree/log"
    exit 1
  fi
}

plant 'std::printf("scene 1\n");'
must_fail "a missing hashes.txt" "is missing"
commit
matrix || { cat "$tree/log"; echo "an honest program is refused"; exit 1; }

plant 'std::printf("scene 2\n");'
must_fail "bytes other than the committed ones" "-scene 1"
plant 'std::printf("scene %d\n", ftz ? 3 : 1);'
must_fail "a dependence on FTZ" "Release called with FTZ and DAZ: other bytes"
plant 'char text[20]; std::snprintf(text, 20, "%.1f", 1.5); std::printf("scene %d\n", text[1] == 44 ? 4 : 1);'
must_fail "a dependence on the locale" "Release in a comma-decimal locale: other bytes"
plant 'int build = 1;
#ifndef NDEBUG
build = 5;
#endif
std::printf("scene %d\n", build);'
must_fail "a dependence on the build type" "g++-Debug: other bytes"

# Only a processor with FMA has another sin to choose.
if grep -q -w fma /proc/cpuinfo 2>/dev/null; then
  plant 'unsigned long long hash = 0;
for (int i = 1; i < 200000; ++i) {
  volatile double x = i * 0.37;
  const double y = std::pow(std::tan(std::sin(x)) + 2, 1.37);
  unsigned long long bits;
  std::memcpy(&bits, &y, sizeof bits);
  hash = (hash ^ bits) * 1099511628211u;
}
std::printf("scene %llu\n", hash);'
  commit
  must_fail "a dependence on libm" "without FMA and AVX2 in libm: other bytes"
fi
echo "matrix.sh refuses every planted program"
