#!/usr/bin/env bash
# Ctrl-C in the middle of a run: exit code 130, and what was computed is on disk and readable.
. "$(dirname "$0")/support.sh"
"$program" run cases/curlew_lab_span.toml --set analysis.cycles=100000 --out "$scratch/out" > "$scratch/said" 2>&1 < /dev/null &
run=$!
sleep 2
kill -INT $run
wait $run
code=$?
[ "$code" -eq 130 ] || { fail "exit code $code where 130 was due"; cat "$scratch/said"; }
grep -q '"status": "interrupted"' "$scratch/out/summary.json" || fail "summary.json does not say that it was interrupted"
[ "$(wc -l < "$scratch/out/cycles.csv")" -ge 2 ] || fail "cycles.csv holds no cycle"
"$program" report "$scratch/out" > /dev/null || fail "the results cannot be read back"
finish
