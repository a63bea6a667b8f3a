#!/usr/bin/env bash
# usage: scripts.sh SCENARIO
# tools/run and tools/test in a copy of the tools folder, with stand-ins for every program they call.
source "$(dirname "$0")/support.sh"

mkdir "$tree/tools"
cp "$tools"/run "$tools"/test "$tools"/*.sh "$tree/tools"
put_program dpkg-query <<'T'
shift 3
for package in "$@"; do [ "$package" = "${MISSING-}" ] || printf '<%s:installed>' "$package"; done
T
put_program id <<<'echo ${USER_ID:-0}'
put_program sudo <<<'exit 1'
put_program apt-get <<<'echo "apt-get $*" >>"$LOG"; exit ${APT_GET_FAILS:-0}'
put_program cmake <<'T'
echo "cmake $*" >>"$LOG"
echo "cmake talks"
case $* in *--build*) echo "${BUILD_ERROR-built}"; exit ${BUILD_FAILS:-0} ;; esac
T
put_program ctest <<<'echo "ctest $*"; echo "the last line of ctest"; exit 8'
for program in ninja g++; do put_program $program <<<'exit 99'; done
put build/release/strandyn < <(printf '#!/bin/sh\necho "in $PWD: $*"; exit 3\n')
chmod +x "$tree/build/release/strandyn"
put build/release/build.ninja <<<''
put build/release/CMakeCache.txt <<<"CMAKE_HOME_DIRECTORY:INTERNAL=$(cd "$tree" && pwd -P)"
put somewhere/case.toml <<<''
export PATH=$tree/bin:$PATH LOG=$tree/log
unset CMAKE_BUILD_PARALLEL_LEVEL
touch "$LOG"

done_so_far() { said=$(<"$LOG"); }
run_here() { (cd "$tree/somewhere" && ../tools/run "$@"); }

case $1 in
  usage)
    call run_here
    expect_code 2
    expect_words "usage: tools/run CASE.toml"
    call "$tree/tools/test" --help
    expect_code 0
    expect_words "usage: tools/test"
    done_so_far
    expect_silence
    ;;
  passes-on)
    code=0
    said=$(run_here case.toml --set "a.b = 1" 2>/dev/null) || code=$?
    expect_code 3
    [[ $said == "in $tree/somewhere: run case.toml --set a.b = 1" ]] || fail "standard output is not the program's alone"
    done_so_far
    expect_no_words "--preset"
    expect_no_words "apt-get"
    expect_words "--target strandyn"
    ;;
  moved)
    put build/release/CMakeCache.txt <<<"CMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere"
    call run_here case.toml
    done_so_far
    expect_words "cmake --fresh --preset release"
    ;;
  broken-build)
    BUILD_FAILS=1 BUILD_ERROR="x.cpp:1: error: what is this" call run_here case.toml
    expect_code 70
    expect_words "x.cpp:1: error: what is this"
    expect_no_words "in $tree/somewhere"
    ;;
  installs)
    MISSING=libhwy-dev call run_here case.toml
    expect_code 3
    done_so_far
    expect_words "apt-get update"
    expect_words "apt-get install -y --no-install-recommends -o DPkg::Lock::Timeout=600 libhwy-dev"
    ;;
  no-rights)
    MISSING=libhwy-dev USER_ID=1000 call run_here case.toml
    expect_code 69
    expect_words "sudo sh -c 'apt-get update && apt-get install -y --no-install-recommends libhwy-dev'"
    done_so_far
    expect_silence
    ;;
  no-network)
    MISSING=libhwy-dev APT_GET_FAILS=100 call run_here case.toml
    expect_code 69
    expect_words "the installation failed"
    ;;
  selection)
    call "$tree/tools/test" -R beam
    expect_code 8
    expect_words "-LE ^nightly$ -R beam"
    [[ $said == *$'\nthe last line of ctest' ]] || fail "ctest should speak last"
    call "$tree/tools/test" --quick
    expect_words "-LE ^(nightly|slow)$"
    call "$tree/tools/test" --all
    expect_no_words "-LE"
    ;;
  *) fail "no such scenario: $1" ;;
esac
