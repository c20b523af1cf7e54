#!/bin/sh
# symbols.sh NM LIBRARY SOURCES: fails when the library calls what could change a byte or reach outside itself:
# any function of libm except sqrt, the environment, the locale, the console, random numbers of std or libc.
set -eu
nm=$1
library=$2
sources=$3

libm=$(find /lib /usr/lib /lib64 -name 'libm.so.6' 2>/dev/null | head -n 1)
[ -n "$libm" ] || { echo "libm.so.6 is not found: nothing to compare with"; exit 1; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$nm" --dynamic --defined-only --format=posix "$libm" | sed 's/[@ ].*//' | grep -v -x -e sqrt -e sqrtf | sort -u >"$work/forbidden"
[ "$(wc -l <"$work/forbidden")" -gt 100 ] || { echo "$libm lists too few functions to be right"; exit 1; }
cat >>"$work/forbidden" <<'END'
atof
clock
drand48
getenv
printf
putchar
puts
rand
random
scanf
secure_getenv
setlocale
sscanf
strtod
strtof
strtold
time
vprintf
_ZSt4cerr
_ZSt4clog
_ZSt4cout
END

"$nm" --undefined-only --format=posix "$library" | sed -n 's/^\([A-Za-z_][^ ]*\) U.*/\1/p' | sort -u >"$work/undefined"
[ -s "$work/undefined" ] || { echo "$library has no undefined symbols at all: is it the library?"; exit 1; }

status=0
if grep -x -F -f "$work/forbidden" "$work/undefined" >"$work/found"; then
  echo "$library calls:"
  while read -r symbol; do
    echo "  $symbol, in $("$nm" --print-file-name --undefined-only "$library" 2>/dev/null | sed -n "s/^[^:]*:\([^:]*\):.* U $symbol\$/\1/p" | sort -u | tr '\n' ' ')"
  done <"$work/found"
  status=1
fi
if "$nm" --format=posix "$library" | grep -E '^_ZN?K?St[0-9]+(random_device|[a-z_]*distribution)'; then
  echo "$library uses the random distributions of std, whose results differ between libraries"
  status=1
fi
if grep -r -n -E '#[[:space:]]*include[[:space:]]*<(random|iostream)>' --include='*.?pp' "$sources"; then
  echo "the library includes neither <random> nor <iostream>"
  status=1
fi
[ $status -eq 0 ] && echo "$(wc -l <"$work/undefined") undefined symbols, none forbidden"
exit $status
