#!/bin/sh
# layers.sh TREE: fails, naming each line, when an include breaks the ranks of the modules.
#  src/X, its subfolders with it, includes files of its own module and "../Y/…" of strictly lower rank, by the
#  shortest way; apps, examples and bench include <velum/…> and files of their own folder; of bench, only
#  bench/kernels looks inside (docs/decisions/0010).
#  The ranks are this table.
set -eu
tree=$1

find "$tree/src" "$tree/apps" "$tree/examples" "$tree/bench" \
  \( -name '*.hpp' -o -name '*.cpp' -o -name '*.h' -o -name '*.inl' \) -type f 2>/dev/null | sort >"${TMPDIR:-/tmp}/layers.$$"
trap 'rm -f "${TMPDIR:-/tmp}/layers.$$"' EXIT

awk -v tree="$tree/" '
  BEGIN {
    split("base 0 image 1 projection 1 clipping 2 scene 2 spatial 3 shading 3 visibility 4 raycast 4 " \
          "pipeline 5 drawing 6 testing 6", table, " ")
    for (i = 1; i in table; i += 2) rank[table[i]] = table[i + 1] + 0
  }

  function complain(why) {
    printf "%s:%d: #include %s%s\n  %s\n", file, line_number, quote, target, why
    broken = 1
  }

  # path[1..depth]: src, the module, its subfolders, the file.
  function check_library(module, parts, count, up, other) {
    if (quote == "<") {
      if (target ~ /^velum\// || target ~ /^\.\.?\//) complain("the library includes its own files as \"../module/file.hpp\"")
      return
    }
    if (!(module in rank)) {
      complain("the folder src/" module " has no rank: give it one in tests/structure/layers.sh")
      return
    }
    count = split(target, parts, "/")
    for (up = 0; parts[up + 1] == ".."; ++up) continue
    other = parts[up + 1]
    if (up < depth - 2) {  # within the module; a file must not be sought in the folder that the way leads out of
      if (up == 0 ? count > 1 && other in rank : count > up + 1 && other == path[depth - up])
        complain("a file of the own folder is included by its bare name")
    } else if (up > depth - 2 || count < up + 2 || !(other in rank)) {
      complain("expected \"file.hpp\" or \"../module/file.hpp\" with a module that has a rank")
    } else if (other == module) {
      complain("a file of the own folder is included by its bare name")
    } else if (rank[other] >= rank[module]) {
      complain(module " (rank " rank[module] ") may not include " other " (rank " rank[other] ")")
    }
  }

  function check_user(folder) {
    if (quote == "\"" && target ~ /(^|\/)\.\.(\/|$)/) complain(folder " uses <velum/…> and files of its own folder only")
    else if (target ~ /(^|\/)src\//) complain(folder " uses the public headers <velum/…> only")
    else if (quote == "\"" && target ~ /^velum\//) complain("write <" target ">, as a user would")
    else if (folder == "bench" && path[2] != "kernels" && target ~ /^velum\/.*\//)
      complain("frames are measured through <velum/velum.hpp>; only bench/kernels looks inside")
  }

  {
    file = $0
    local_name = substr(file, length(tree) + 1)
    depth = split(local_name, path, "/")
    line_number = 0
    while ((getline line < file) > 0) {
      ++line_number
      if (line !~ /^[ \t]*#[ \t]*include[ \t]*["<]/) continue
      sub(/^[ \t]*#[ \t]*include[ \t]*/, "", line)
      quote = substr(line, 1, 1)
      target = substr(line, 2)
      sub(/[">].*/, "", target)
      if (path[1] != "src") check_user(path[1])
      else if (depth > 2) check_library(path[2])
    }
    close(file)
    ++files
  }

  END {
    if (files == 0) { print "no files found under " tree; exit 1 }
    if (broken) exit 1
    print files " files keep the ranks"
  }
' "${TMPDIR:-/tmp}/layers.$$"
