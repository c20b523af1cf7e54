#!/bin/sh
# format.sh [--fix] TREE: demands, or makes, the form of .clang-format. Version 14, because others format otherwise.
set -eu
mode='--dry-run -Werror'
if [ "$1" = --fix ]; then
  mode='-i'
  shift
fi
cd "$1"

tool=clang-format-14
command -v $tool >/dev/null || tool=clang-format
case "$($tool --version 2>/dev/null)" in
  *'version 14.'*) ;;
  *) echo "clang-format 14 is not found; on Debian 12: apt-get install clang-format"; exit 1 ;;
esac

# shellcheck disable=SC2086 # the mode is several words
find src apps examples bench tests \( -name '*.cpp' -o -name '*.hpp' \) -type f | sort | xargs $tool $mode
