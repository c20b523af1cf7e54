#!/bin/sh
# docs_made_self_test.sh TREE PROGRAM: demands that docs_made.sh refuses a changed number, a changed picture, one too
# many, and a part that nothing makes.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
tree=$(cd "$1" && pwd)
program=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fresh() {
  rm -rf "$work/docs"
  cp -R "$tree/docs" "$work/docs"
}

refused() {
  if "$here/docs_made.sh" "$work" "$program" >/dev/null 2>&1; then
    echo "not refused: $1"
    exit 1
  fi
}

fresh
sed 's/^| world  */&1/' "$tree/docs/pipeline.md" >"$work/docs/pipeline.md"
refused "a changed number"
fresh
cp "$work/docs/pictures/spans.png" "$work/docs/pictures/scene.png"
refused "a changed picture"
fresh
cp "$work/docs/pictures/spans.png" "$work/docs/pictures/more.png"
refused "a picture too many"
fresh
printf '%s\n' '<!-- made: nothing -->' '<!-- end -->' >>"$work/docs/pipeline.md"
refused "a part that nothing makes"
echo "docs_made.sh refuses every planted difference"
