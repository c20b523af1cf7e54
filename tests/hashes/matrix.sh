#!/bin/sh
# matrix.sh SOURCE BUILD [VARIANT PROGRAM]: builds velum_hashes with each compiler and build type under BUILD, runs it plain,
# without fused multiply-add in libm, for a caller that flushes denormals, and in a comma-decimal locale, and demands
# that every output equals the committed hashes.txt. PROGRAM is a velum_hashes that is there, for its VARIANT.
# VELUM_HASHES_VARIANTS names other builds than those below, "compiler-type" each.
set -eu
source=$(cd "$1" && pwd)
mkdir -p "$2"
build=$(cd "$2" && pwd)
committed=$source/tests/hashes/hashes.txt
built_variant=${3:-}
built_program=${4:-}
variants=${VELUM_HASHES_VARIANTS:-g++-Release clang++-Release g++-Debug clang++-Debug}

LOCPATH=$build/locale
if [ ! -d "$LOCPATH/de_DE.UTF-8" ]; then
  mkdir -p "$LOCPATH"
  localedef -i de_DE -f UTF-8 "$LOCPATH/de_DE.UTF-8" ||
    { rm -rf "$LOCPATH"; echo "localedef cannot make de_DE; on Debian: apt-get install locales"; exit 1; }
fi
export LOCPATH

make_program() { # VARIANT
  cmake -S "$source" -B "$build/$1" -G Ninja -DCMAKE_CXX_COMPILER="${1%-*}" -DCMAKE_BUILD_TYPE="${1##*-}" \
    -DVELUM_BUILD_HASHES=ON -DVELUM_BUILD_TESTS=OFF -DVELUM_BUILD_APPS=OFF -DVELUM_BUILD_EXAMPLES=OFF \
    -DVELUM_BUILD_BENCHMARKS=OFF -DVELUM_WERROR=ON >"$build/log" 2>&1 &&
    cmake --build "$build/$1" --target velum_hashes >"$build/log" 2>&1 || { cat "$build/log"; exit 1; }
}

[ -s "$committed" ] || { echo "$committed is missing; ./run goldens writes it"; exit 1; }

status=0
compare() { # NAME COMMAND...
  name=$1
  shift
  if ! "$@" >"$build/output" 2>"$build/errors"; then
    echo "$name: velum_hashes fails:"
    cat "$build/errors"
    status=1
  elif ! diff -u --label committed --label "$name" "$committed" "$build/output"; then
    echo "$name: other bytes than the committed ones"
    status=1
  else
    echo "$name: the same $(wc -l <"$committed") hashes"
  fi
}

for variant in $variants; do
  if [ "$variant" = "$built_variant" ]; then
    program=$built_program
  else
    make_program "$variant"
    program=$build/$variant/bin/velum_hashes
  fi
  compare "$variant" "$program"
  compare "$variant without FMA and AVX2 in libm" env GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2 "$program"
  compare "$variant called with FTZ and DAZ" "$program" --ftz
  compare "$variant in a comma-decimal locale" "$program" --locale
done
exit $status
