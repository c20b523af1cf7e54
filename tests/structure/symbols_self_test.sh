#!/bin/sh
# symbols_self_test.sh CXX AR NM: builds small libraries, each with one forbidden call, and demands that symbols.sh
# finds it.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cxx=$1
ar=$2
nm=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/src"

# verdict BODY: symbols.sh on a library with this body
verdict() {
  rm -f "$work/library.a"
  printf '%s\n' '#include <cmath>' '#include <cstdlib>' '#include <cstdio>' "$1" >"$work/library.cpp"
  "$cxx" -std=c++20 -O0 -c "$work/library.cpp" -o "$work/library.o"
  "$ar" rc "$work/library.a" "$work/library.o"
  "$here/symbols.sh" "$nm" "$work/library.a" "$work/src"
}

verdict 'double f(double x) { return std::sqrt(x); } int g(); int h() { return g(); }' >/dev/null || { echo "sqrt is refused"; exit 1; }
for body in 'double f(double x) { return std::sin(x); }' 'float f(float x) { return std::pow(x, x); }' \
  'double f(double x) { return std::fma(x, x, x); }' 'double f(double x) { return std::fmod(x, 3.0); }' \
  'double f(double x) { return std::floor(x); }' 'double f(double x) { return std::lround(x); }' \
  'char* f() { return std::getenv("HOME"); }' 'double f(const char* s) { return std::strtod(s, nullptr); }' \
  'void f(const char* s) { std::puts(s); }' \
  '#include <random>
int f() { std::mt19937 g; return std::uniform_int_distribution<int>(0, 9)(g); }'; do
  if verdict "$body" >/dev/null; then
    echo "symbols.sh does not see: $body"
    exit 1
  fi
done

printf '%s\n' '#include <iostream>' >"$work/src/a.cpp"
if verdict 'int g(); int h() { return g(); }' >/dev/null; then
  echo "symbols.sh does not see <iostream>"
  exit 1
fi
echo "symbols.sh finds every planted call"
