#!/usr/bin/env bash
# `verify extremes`: rows by name, as words, JSON and Markdown; progress apart; exit codes.
. "$(dirname "$0")/support.sh"

"$program" verify extremes tension/slack > "$scratch/table" 2> "$scratch/progress"
[ $? -eq 0 ] || fail "rows that hold do not end with exit code 0"
grep -q "must hold  nothing presses: EI_min, no loss" "$scratch/table" || fail "a row does not print its bound"
grep -q "^2 of 2 extremes hold$" "$scratch/table" || fail "the rows are not counted"
grep -q "of the ordinary case" "$scratch/table" || fail "a row does not print its cost"
grep -qx "running tension/slack" "$scratch/progress" || fail "a row is not named before it runs"
grep -q running "$scratch/table" && fail "progress is among the results"

"$program" verify extremes tension/slack --json > "$scratch/json" 2> /dev/null
[ $? -eq 0 ] || fail "--json changes the exit code"
for key in name extreme bound found value at_most holds cost_ratio cost_unit cpu_s passed; do
  grep -q "\"$key\":" "$scratch/json" || fail "the JSON does not tell $key"
done
"$program" verify extremes tension/slack --markdown 2> /dev/null | grep -q "^| slack | no tension" || fail "no Markdown"

expect_code 2 "a row that is not there" "$program" verify extremes no-such-row
expect_said "no row of the extremes"
"$program" verify tensioned_beam_pinned --markdown 2> /dev/null | grep -q "^| .frequencies_Hz\[0\]. | .* | passed |" || fail "no Markdown of cases"
"$program" verify extremes tension/slack > /dev/full 2> /dev/null
[ $? -eq 4 ] || fail "a table that cannot be written"
finish
