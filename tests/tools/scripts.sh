#!/usr/bin/env bash
# usage: scripts.sh SCENARIO
# tools/run and tools/test in a copy of the tools folder, with stand-ins for every program they call.
source "$(dirname "$0")/support.sh"

mkdir "$tree/tools"
cp "$tools"/run "$tools"/test "$tools"/try_in_debian "$tools"/*.sh "$tree/tools"
put_program dpkg-query <<'T'
shift 3
for package in "$@"; do [ "$package" = "${MISSING-}" ] || printf '<%s:installed>' "$package"; done
T
put_program id <<<'echo ${USER_ID:-0}'
put_program sudo <<<'exit 1'
put_program apt-get <<'T'
[ -n "${APT_GET_FAILS-}" ] && exit "$APT_GET_FAILS"
case $* in
  *--assume-no*)
    echo "0 upgraded, 7 newly installed, 0 to remove and 0 not upgraded."
    echo "Need to get 90.5 MB/96.8 MB of archives."
    echo "After this operation, 377 MB of additional disk space will be used."
    exit 1 ;;
  *--print-uris*) echo "'address' libsundials-dev_7_any.deb 1046920 SHA256:0"; exit 0 ;;
  "download "*) : >libsundials-dev_7_any.deb ;;
  *" install "* | "install "*) sleep "${APT_GET_TAKES:-0}" ;;
esac
echo "apt-get $*" >>"$LOG"
T
put_program dpkg-deb <<'T'
folder=$(mktemp -d)
mkdir -p "$folder/usr/include/ida" "$folder/usr/lib/machine" "$folder/usr/share/doc"
touch "$folder/usr/include/ida/ida.h"
for library in ida core idas; do touch "$folder/usr/lib/machine/libsundials_$library.a"; done
tar -c -C "$folder" ./usr
rm -r "$folder"
T
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
unpacked=$tree/build/deps/sundials
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
    expect_words "apt-get install --no-install-recommends -o DPkg::Lock::Timeout=600 -y libhwy-dev"
    ;;
  says-first)
    MISSING=libhwy-dev APT_GET_TAKES=1.5 STRANDYN_SIGN_S=0.5 call run_here case.toml
    expect_words "(7 packages, 90.5 MB to fetch, 377 MB on the disk): libhwy-dev"
    [[ $said == *"377 MB on the disk"*"s, 7 packages: 0 fetched, 0 unpacked, 0 set up"* ]] || fail "no sign of life afterwards"
    ;;
  unpacks)
    for user in 0 1000; do
      rm -rf "$unpacked"
      : >"$LOG"
      MISSING=libsundials-dev USER_ID=$user call run_here case.toml
      expect_code 3
      expect_words "fetching libsundials-dev, 1.0 MB"
      [[ $(cd "$unpacked" && find . -type f | sort | tr '\n' ' ') == \
        "./include/ida/ida.h ./lib/libsundials_core.a ./lib/libsundials_ida.a " ]] || fail "not what was to be unpacked"
      done_so_far
      expect_words "apt-get download libsundials-dev"
      expect_no_words "apt-get install"
    done
    expect_no_words "apt-get update"
    : >"$LOG"
    MISSING=libsundials-dev call run_here case.toml
    done_so_far
    expect_no_words "apt-get"
    ;;
  unpacks-not)
    MISSING=libsundials-dev USER_ID=1000 APT_GET_FAILS=100 call run_here case.toml
    expect_code 69
    expect_words "sudo sh -c 'apt-get update'"
    [[ ! -e $unpacked ]] || fail "half of a package is left"
    ;;
  same-build)
    mkdir "$tree/.ci"
    cp "$tools/../.ci/run" "$tree/.ci"
    put tools/check_nothing <<<''
    chmod +x "$tree/tools/check_nothing"
    call "$tree/.ci/run"
    expect_code 8
    done_so_far
    expect_words "cmake --preset ci"
    expect_no_words "--fresh"
    ;;
  debian-skipped)
    USER_ID=1000 call "$tree/tools/try_in_debian" trixie
    expect_code 77
    expect_words "not root"
    call "$tree/tools/try_in_debian"
    expect_code 2
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
