#!/bin/sh
# conventions.sh TREE: every test that docs/conventions.md names exists, in the file it names.
set -eu
cd "$1"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# One line per pair of file and test name: file, tab, name.
tab=$(printf '\t')
grep -o '`[a-z_]*/[a-z_]*_test\.cpp` "[^"]*"' docs/conventions.md | sed "s/^\`//; s/\` \"/$tab/; s/\"\$//" >"$work/pairs"
[ -s "$work/pairs" ] || { echo "docs/conventions.md names no test"; exit 1; }

broken=0
while IFS="$tab" read -r file name; do
  # A long name may be broken over two string literals: they are joined first.
  if [ ! -f "tests/$file" ] || ! tr '\n' ' ' <"tests/$file" | sed 's/" *"//g; s/TEST_CASE( */TEST_CASE(/g' |
    grep -qF "TEST_CASE(\"$name"; then
    echo "docs/conventions.md: tests/$file has no test that begins with \"$name\""
    broken=1
  fi
done <"$work/pairs"

# Every row of a table names a test.
if grep -n '^|' docs/conventions.md | grep -v -e '|---|' -e '| convention | test |' | grep -v '_test\.cpp` "'; then
  echo "docs/conventions.md: the rows above name no test"
  broken=1
fi
[ "$broken" -eq 0 ] && echo "$(wc -l <"$work/pairs") named tests exist"
exit "$broken"
