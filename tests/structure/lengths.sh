#!/bin/sh
# lengths.sh TREE: fails for every C++ file over 400 lines: one noun or verb per file.
set -eu
limit=400
cd "$1"
find src apps examples bench tests \( -name '*.cpp' -o -name '*.hpp' \) -type f | sort | xargs wc -l | awk -v limit="$limit" '
  $2 == "total" { next }
  { ++files }
  $1 > limit { print $2 ": " $1 " lines, more than " limit ": it does more than one job"; broken = 1 }
  END { if (files == 0) { print "no files found"; exit 1 } if (!broken) print files " files, none over " limit " lines"; exit broken }'
