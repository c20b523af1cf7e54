#!/bin/sh
# mutations.sh SOURCE WORK CXX LIBRARIES FLAGS OBJECTS...: plants ten small faults, one at a time, into copies of the two
# reference rasters and demands that the visibility tests see each of them; and that they pass without any.
#
# SOURCE   the project's tree             LIBRARIES  the built library, which gives everything else, and what it links
# WORK     an empty folder of its own     FLAGS      compiler flags; like the libraries, separated by spaces
# CXX      the compiler                   OBJECTS    the visibility tests' objects, separated by ;
set -eu
source=$1
work=$2
cxx=$3
libraries=$4
flags=$5
shift 5
objects=$(printf '%s ' "$@" | tr ';' ' ')
tests='*/scanline_test.cpp,*/watertight_test.cpp'
rm -rf "$work"
mkdir -p "$work"

# replace_once FROM TO FILE OUT: FROM must stand in the file exactly once.
replace_once() {
  FROM=$1 TO=$2 awk '
    BEGIN { RS = "\001"; ORS = "" }
    { text = text $0 }
    END {
      at = index(text, ENVIRON["FROM"])
      if (at == 0) exit 1
      rest = substr(text, at + length(ENVIRON["FROM"]))
      if (index(rest, ENVIRON["FROM"]) != 0) exit 1
      print substr(text, 1, at - 1) ENVIRON["TO"] rest
    }' "$3" >"$4"
}

# run_with NAME: builds the raster of this name in WORK, links it before the library's own, runs the tests.
run_with() {
  # shellcheck disable=SC2086 # flags and objects are several words
  "$cxx" $flags -O1 -I"$source/src/visibility" -c "$work/$1.cpp" -o "$work/$1.o" || return
  # shellcheck disable=SC2086
  "$cxx" "$work/$1.o" $objects $libraries -o "$work/$1" || return
  timeout 60 "$work/$1" --source-file="$tests" --abort-after=1 >"$work/$1.log" 2>&1
}

count=0
missed=0
# mutant RASTER WHAT FROM TO
mutant() {
  count=$((count + 1))
  name=$1_$count
  replace_once "$3" "$4" "$source/src/visibility/$1_reference.cpp" "$work/$name.cpp" || {
    echo "$1: \"$3\" does not stand there exactly once; bring mutations.sh up to date"
    exit 1
  }
  status=0
  run_with "$name" || status=$?
  if [ ! -x "$work/$name" ]; then
    echo "$1, $2: does not build"
    exit 1
  elif [ "$status" -eq 0 ]; then
    echo "MISSED  $1: $2"
    missed=$((missed + 1))
  else
    echo "seen    $1: $2"
  fi
}

for raster in zbuffer scanline; do
  cp "$source/src/visibility/${raster}_reference.cpp" "$work/$raster.cpp"
  run_with "$raster" || {
    [ ! -f "$work/$raster.log" ] || cat "$work/$raster.log"
    echo "$raster without a fault does not pass"
    exit 1
  }
done

mutant zbuffer 'a sample shifted by one pixel for one edge' \
  'EdgeFunction::between(v[0], v[1], box.left, box.top)' 'EdgeFunction::between(v[0], v[1], box.left + 1, box.top)'
mutant zbuffer '> for >= in the coverage test' '(e0 | e1 | e2) >= 0' '(e0 | e1 | e2) > 0'
mutant zbuffer 'a swapped tie' \
  'is_nearer(r, triangle.primitive, buffer_r, buffer_id)' 'is_nearer(r, buffer_id, buffer_r, triangle.primitive)'
mutant zbuffer 'the box begins right of a centre on its edge' \
  '(snapped - subpixels / 2 + subpixels - 1)' '(snapped - subpixels / 2 + subpixels)'
mutant zbuffer "an edge walked with another edge's step" 'e1 += edges[1].step_x;' 'e1 += edges[2].step_x;'

mutant scanline 'a sample shifted by 1/256 pixel' \
  '(std::int64_t{upper.x} - subpixels / 2)' '(std::int64_t{upper.x} - subpixels / 2 + 1)'
mutant scanline '<= for < in the step' 'if (edge.excess < 0)' 'if (edge.excess <= 0)'
mutant scanline 'a swapped tie' \
  'nearness(r, id) <= nearness(buffer_r, buffer_id)' 'nearness(r, buffer_id) <= nearness(buffer_r, id)'
mutant scanline 'a wrong remainder' '(width - step * height) * subpixels' '(width - step * height) * subpixels + 1'
mutant scanline 'the top-left rule turned round' \
  'n = ceil_divide(numerator, edge.denominator)' 'n = floor_divide(numerator, edge.denominator) + 1'

echo "$((count - missed)) of $count faults seen"
[ "$missed" -eq 0 ] && [ "$count" -eq 10 ]
