#!/usr/bin/env bash
# usage: check_format.sh SCENARIO
source "$(dirname "$0")/support.sh"

put .clang-format <<<'BasedOnStyle: Google'
put src/good.cpp <<<'int f() { return 1; }'

case $1 in
  missing)
    CLANG_FORMAT=no-such-program call "$tools/check_format" "$tree"
    expect_code 0
    expect_words "no-such-program not installed, skipped"
    ;;
  places)  # with a stand-in for clang-format, because it may not be installed
    put_program stand-in <<'T'
for file in "$@"; do
  case $file in
    *crooked*) printf '%s:12:3: warning: code should be clang-formatted\n  int  x;\n     ^\n' "$file"
               printf '%s:12:9: warning: code should be clang-formatted\n' "$file"; status=1 ;;
  esac
done
exit ${status:-0}
T
    export CLANG_FORMAT=$tree/bin/stand-in
    accepted check_format
    put src/crooked.hpp <<<'anything'
    refused check_format "src/crooked.hpp:12: not as clang-format leaves it"
    (($(grep -c 'crooked.hpp:12' <<<"$said") == 1)) || fail "the line should be named once"
    ;;
  real)  # registered where clang-format is installed
    accepted check_format
    put src/crooked.cpp <<<'int   f( ){return 1;}'
    refused check_format "src/crooked.cpp:1: not as clang-format leaves it"
    put .clang-format <<<'BasedOnStyle: no-such-style'
    refused check_format "no-such-style"
    ;;
  *) fail "no such scenario: $1" ;;
esac
