#!/usr/bin/env bash
# Results go to standard output, words for people to standard error; every verb answers.
. "$(dirname "$0")/support.sh"
sed '/^\[accept\]/,$d' cases/curlew_lab_span.toml > "$scratch/case.toml"
"$program" run "$scratch/case.toml" --set analysis.cycles=3 --json --out "$scratch/a" > "$scratch/json" 2> "$scratch/words" < /dev/null
cmp -s "$scratch/json" "$scratch/a/summary.json" || fail "--json prints something else than summary.json"
grep -q "warning\|results in" "$scratch/words" || fail "nothing for people on standard error"
"$program" run "$scratch/case.toml" --set analysis.cycles=3 --out "$scratch/c" > "$scratch/tables" 2> /dev/null < /dev/null
grep -q "Energy of each cycle" "$scratch/tables" || fail "no table of energy per cycle on standard output"
grep -q "antinode amplitude" "$scratch/tables" || fail "the numbers to look at first are not on standard output"
grep -q "own damping ratio will be" "$scratch/words" || fail "the integrator's own damping is not said beforehand"
"$program" run "$scratch/case.toml" --set analysis.cycles=3 --quiet --out "$scratch/b" > "$scratch/out" 2> "$scratch/words" < /dev/null
[ ! -s "$scratch/out" ] && [ ! -s "$scratch/words" ] || fail "--quiet is not quiet"
cmp -s "$scratch/a/cycles.csv" "$scratch/b/cycles.csv" || fail "the same case gives other bytes"

expect_code 0 "check" "$program" check "$scratch/case.toml"
expect_code 0 "describe" "$program" describe "$scratch/case.toml"
expect_said "steps per cycle"
expect_code 0 "describe as JSON" "$program" describe "$scratch/case.toml" --json
expect_said '"tension_N": 24420.0'
expect_said '"predicted_numerical_damping_ratio": 7.75'
expect_code 0 "conductors" "$program" conductors
expect_said "drake"
expect_code 0 "one conductor" "$program" conductors curlew
expect_said "[[conductor.layer]]"
expect_code 2 "an unknown conductor" "$program" conductors curlow
expect_said "curlew"
expect_code 0 "schema" "$program" schema
expect_said "steps_per_cycle"
"$program" schema --keys | cmp -s - docs/keys.md || fail "docs/keys.md is not what schema --keys prints"
"$program" schema --results | cmp -s - docs/outputs.md || fail "docs/outputs.md is not what schema --results prints"
expect_code 0 "report" "$program" report "$scratch/a"
[ -s "$scratch/a/report.html" ] || fail "no page"
finish
