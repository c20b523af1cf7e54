#!/bin/sh
# smoke.sh BENCH: velum-bench runs, writes what it says, and tells mistakes clearly, with no data to hand. Nothing here
# looks at a time.
set -eu
bench=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

fail() {
  echo "$1"
  cat out.txt error.txt
  exit 1
}
# expect CODE ARGUMENT...: runs it with these arguments and demands the exit code
expect() {
  code=0
  wanted=$1
  shift
  "$bench" "$@" >out.txt 2>error.txt || code=$?
  [ "$code" -eq "$wanted" ] || fail "velum-bench $*: exit code $code, not $wanted"
}
# says FILE WORDS
says() { grep -qF -- "$2" "$1" || fail "$1 does not say \"$2\""; }

expect 0 --help
says out.txt '--check'

expect 0 --data nowhere --scene fill32_f2b --scene builtin-sphere --mode zbuffer --mode depth --frames 1 --alone
says out.txt 'builtin-sphere'
[ "$(wc -l <out/bench/frames.csv)" -eq 5 ] || fail 'frames.csv does not have a line per scene and mode'
says out/bench/frames.svg '</svg>'

# With llvmpipe, where it is built in: an exit code of 0 means that both show the same pixels.
expect 0 --data nowhere --scene builtin-sphere --frames 1 --no-memory --markdown --out elsewhere
says out.txt '| builtin-sphere |'
[ -s elsewhere/frames.csv ] || fail '--out is not obeyed'

expect 1 --data nowhere --scene bunny
says error.txt 'nowhere'
expect 2 --scene no-such-scene
expect 2 --check --growth
: >plain-file
expect 1 --scene fill32_f2b --frames 1 --alone --no-memory --out plain-file/folder
says error.txt 'cannot be written'
echo "velum-bench runs"
