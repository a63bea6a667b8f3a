# Sourced by the tests of the scripts: a throw-away tree, and what a script is expected to answer.
# shellcheck shell=bash
set -euo pipefail

tools=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../tools" && pwd -P)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT

fail() {
  printf 'FAILED: %s\n' "$1" >&2
  printf -- '--- what the script said\n%s\n' "${said-}" >&2
  exit 1
}

# put PATH: writes standard input to that file of the tree.
put() {
  mkdir -p "$tree/$(dirname "$1")"
  cat >"$tree/$1"
}

# put_program NAME: the same, as a program of the folder $tree/bin.
put_program() {
  { echo '#!/bin/sh'; cat; } | put "bin/$1"
  chmod +x "$tree/bin/$1"
}

# call COMMAND...: keeps what it says (both streams) in $said and its exit code in $code.
call() {
  code=0
  said=$("$@" 2>&1) || code=$?
}

expect_code() { ((code == $1)) || fail "exit code $code instead of $1"; }
expect_words() { [[ $said == *"$1"* ]] || fail "the words are missing: $1"; }
expect_no_words() { [[ $said != *"$1"* ]] || fail "these words should not be there: $1"; }
expect_silence() { [[ -z $said ]] || fail "silence was expected"; }

# refused CHECK WORDS: the check refuses the tree and says why. accepted CHECK: it passes without a word.
refused() {
  call "$tools/$1" "$tree"
  expect_code 1
  expect_words "$2"
}
accepted() {
  call "$tools/$1" "$tree"
  expect_code 0
  expect_silence
}
