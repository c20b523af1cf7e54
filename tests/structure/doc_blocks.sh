#!/bin/sh
# doc_blocks.sh TREE: every ```cpp block of README.md and docs/ stands word for word in a file under examples/, which
# the build compiles and the tests run; so a page cannot show what does not work.
set -eu
cd "$1"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

find README.md $([ ! -d docs ] || echo docs) -name "*.md" -type f | sort >"$work/pages"
find examples -name '*.cpp' -type f | sort >"$work/examples"

awk -v examples="$work/examples" '
  function slurp(name, text, line) {
    while ((getline line < name) > 0) text = text line "\n"
    close(name)
    return text
  }

  function check_block(name) {
    ++blocks
    for (name in example) if (index(example[name], block)) return
    printf "%s:%d: this block is in no file under examples/\n", page, start
    broken = 1
  }

  BEGIN { while ((getline name < examples) > 0) example[name] = "\n" slurp(name) }

  {
    page = $0
    inside = 0
    number = 0
    while ((getline line < page) > 0) {
      ++number
      if (!inside && line ~ /^[ \t]*```(cpp|c\+\+|C\+\+)/) {
        if (line !~ /^```cpp$/) { printf "%s:%d: write ```cpp, at the start of the line\n", page, number; broken = 1 }
        inside = 1
        start = number
        block = "\n"
      } else if (inside && line ~ /^[ \t]*```/) {
        inside = 0
        check_block()
      } else if (inside) {
        block = block line "\n"
      }
    }
    close(page)
    if (inside) { printf "%s:%d: this block does not end\n", page, start; broken = 1 }
  }

  END { if (!broken) print blocks + 0 " C++ blocks, all in examples/"; exit broken }
' "$work/pages"
