#!/usr/bin/env bash
# usage: check_length.sh SCENARIO
source "$(dirname "$0")/support.sh"

put src/short.cpp < <(seq 400)
put bench/data.txt < <(seq 800)     # outside of the four folders
put tests/measured.csv < <(seq 800) # data

case $1 in
  short) accepted check_length ;;
  limit)
    put src/beam/edge.cpp < <(seq 700)
    call "$tools/check_length" "$tree"
    expect_code 0
    put src/beam/over.cpp < <(seq 701)
    refused check_length "src/beam/over.cpp: 701 lines"
    expect_no_words "edge.cpp: 700"
    ;;
  note)
    put src/beam/long.cpp < <(seq 401)
    call "$tools/check_length" "$tree"
    expect_code 0
    expect_words "above 400 lines without a reason in tools/long_files.txt: src/beam/long.cpp (401)"
    put tools/long_files.txt <<<'src/beam/long.cpp: one kernel, read from top to bottom'
    accepted check_length
    ;;
  list)
    put src/beam/long.cpp < <(seq 401)
    put tools/long_files.txt <<<'src/beam/long.cpp:'
    refused check_length "tools/long_files.txt:1: src/beam/long.cpp is listed without a reason"
    put tools/long_files.txt <<<$'# path: reason\nsrc/short.cpp: it was long once'
    refused check_length "tools/long_files.txt:2: src/short.cpp has no more than 400 lines"
    ;;
  *) fail "no such scenario: $1" ;;
esac
