#!/bin/sh
# doc_commands.sh TREE BIN: runs every `velum …` line of the ```sh blocks of README.md and docs/, in order, in an empty
# folder where bunny.obj lies. `./run …`, cmake, git and cd lines are left out (the tests call those on their own);
# any other line fails, because nobody would notice when it stops working.
set -eu
tree=$(cd "$1" && pwd)
bin=$(cd "$2" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cd "$tree"
find README.md $([ ! -d docs ] || echo docs) -name "*.md" -type f | sort | xargs awk '
  FNR == 1 { inside = 0 }
  !inside && /^```(sh|bash|console)$/ { inside = 1; next }
  inside && /^```/ { inside = 0; next }
  !inside { next }
  /^[ \t]*(#|$)/ { next }
  { line = line $0 }
  /\\$/ { sub(/\\$/, "", line); next }
  { print FILENAME ":" FNR "\t" line; line = "" }
' >"$work/commands"

mkdir "$work/folder"
cd "$work/folder"
bunny=/usr/share/glmark2/models/bunny.obj
if [ -f "$bunny" ]; then cp "$bunny" .; fi

PATH="$bin:$PATH"
count=0
tab=$(printf '\t')
while IFS="$tab" read -r place command; do
  case "$command" in
    './run '* | './run' | 'cmake '* | 'git '* | 'cd '*) continue ;;
    'velum '*) ;;
    *) echo "$place: nothing tests this line: $command"; exit 1 ;;
  esac
  echo "$place: $command"
  sh -c "$command" </dev/null >"$work/output" 2>&1 || { cat "$work/output"; echo "$place: this command fails (exit code $?)"; exit 1; }
  count=$((count + 1))
done <"$work/commands"
echo "$count commands run"
