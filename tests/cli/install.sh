#!/usr/bin/env bash
# The installed program works from an empty folder, and a program of ten lines is built against the installed library.
source "$(dirname "$0")/support.sh"

build=$(dirname "$program")
root=$(cd "$(dirname "$0")/../.." && pwd)
prefix=$scratch/prefix
cmake --install "$build" --prefix "$prefix" >"$scratch/installed" || fail "cmake --install"
installed=$prefix/bin/strandyn
[[ -s $prefix/share/man/man1/strandyn.1 ]] || fail "no page of the manual"
[[ -s $prefix/share/bash-completion/completions/strandyn ]] || fail "no completion"

mkdir "$scratch/empty"
cd "$scratch/empty"
"$installed" verify beam/elastica_10 >"$scratch/verified" || fail "the installed program does not find the installed cases"
grep -q "1 of 1 cases hold" "$scratch/verified" || fail "$(cat "$scratch/verified")"
"$installed" run "$prefix/share/strandyn/cases/curlew_modes.toml" --report --quiet || fail "the installed program does not run"
[[ -s results/curlew_modes/report.html ]] || fail "no page"

example=$root/docs/examples/library
cmake -S "$example" -B "$scratch/library" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Debug >"$scratch/configured" ||
  fail "find_package(strandyn): $(tail -n 5 "$scratch/configured")"
cmake --build "$scratch/library" >"$scratch/built" 2>&1 || fail "the example does not build: $(tail -n 20 "$scratch/built")"
"$scratch/library/summary" "$prefix/share/strandyn/cases/curlew_modes.toml" >"$scratch/summary.json" ||
  fail "the example does not run"
# The library is the program: all but clocks alike.
for file in "$scratch/summary.json" results/curlew_modes/summary.json; do
  grep -v '"wall_s"\|"cpu_s"\|"accept"' "$file" >"$file.plain"
done
cmp "$scratch/summary.json.plain" results/curlew_modes/summary.json.plain || fail "the library's summary is another"
finish
