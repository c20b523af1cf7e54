#!/bin/sh
# docs_made.sh TREE PROGRAM: makes the numbers and pictures of docs/pipeline.md again, in another folder, and demands
# that every byte is as committed. `./run docs` refreshes them.
set -eu
tree=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cp "$tree/docs/pipeline.md" "$work/pipeline.md"
"$2" --page "$work/pipeline.md" --pictures "$work/pictures" >"$work/written"
if ! diff -u "$tree/docs/pipeline.md" "$work/pipeline.md" || ! diff -rq "$tree/docs/pictures" "$work/pictures"; then
  echo "docs/ is not what the program makes now: ./run docs, look at the changes, commit them"
  exit 1
fi
for picture in "$work"/pictures/*; do
  name=pictures/$(basename "$picture")
  grep -qF "($name)" "$work/pipeline.md" "$tree"/docs/*.md || { echo "no page of docs/ shows $name"; exit 1; }
done
echo "docs/pipeline.md and $(find "$work/pictures" -type f | wc -l) pictures are as made"
