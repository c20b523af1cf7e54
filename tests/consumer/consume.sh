#!/bin/sh
# consume.sh HOW SOURCE BUILD CXX: configures, builds and runs the consumer in an empty folder.
#   package       velum is installed from BUILD into an empty prefix and found by find_package
#   subdirectory  velum is built as a part of the consumer
#   fetch         velum comes through FetchContent; configured only, since it is built like a subdirectory
set -eu
how=$1
source=$2
build=$3
cxx=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

if [ "$how" = package ]; then
  cmake --install "$build" --prefix "$work/prefix" >"$work/log" || { cat "$work/log"; exit 1; }
  [ "$(ls "$work/prefix/include")" = velum ] || { echo "more than velum/ under include/:"; ls "$work/prefix/include"; exit 1; }
  if grep -r -l -F -e "$source" -e "$build" "$work/prefix" --include='*.cmake' --include='*.hpp'; then
    echo "these installed files name the folder velum was built in"
    exit 1
  fi
  # The source is out of reach, so that nothing but the installed files can be used.
  set -- -DCMAKE_PREFIX_PATH="$work/prefix"
else
  set -- -DVELUM_SOURCE="$source"
fi

cp "$source/tests/consumer/CMakeLists.txt" "$source/tests/consumer/consumer.cpp" "$work"
cmake -S "$work" -B "$work/build" -G Ninja -DHOW="$how" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER="$cxx" \
  -DCMAKE_CXX_FLAGS='-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror' "$@" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
[ "$how" != fetch ] || exit 0
cmake --build "$work/build" --target consumer >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
cd "$work"
build/consumer || { echo "the consumer's picture is not right (exit code $?)"; exit 1; }
[ -s cube.png ]
