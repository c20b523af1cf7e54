#!/bin/sh
# Demands that doc_blocks.sh accepts a block that an example has, and refuses one that differs by a character.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir "$tree/docs" "$tree/examples"
printf '%s\n' 'int f();' 'int main() {' '  return f();' '}' >"$tree/examples/a.cpp"

# page LANGUAGE LINE...
page() {
  language=$1
  shift
  { printf '%s\n' 'Text.' "\`\`\`$language"; printf '%s\n' "$@"; printf '%s\n' '```' 'More.'; } >"$tree/README.md"
}

refused() {
  if "$here/doc_blocks.sh" "$tree" >/dev/null; then
    echo "not refused: $1"
    exit 1
  fi
}

page cpp 'int main() {' '  return f();' '}'
"$here/doc_blocks.sh" "$tree" >/dev/null || { echo "a true block is refused"; exit 1; }
page cpp 'int main() {' '  return g();' '}'
refused "a block that differs"
page cpp 'main() {'
refused "a part of a line"
page 'cpp title' 'int f();'
refused "a fence that is not plain"
page sh 'int f();'
printf '%s\n' '```cpp' 'int h();' '```' >"$tree/docs/page.md"
refused "a false block in docs/"
echo "doc_blocks.sh refuses every planted block"
