#!/usr/bin/env bash
# Every ending has its exit code and says what to change.
. "$(dirname "$0")/support.sh"
lab=cases/curlew_lab_span.toml
sed '/^\[accept\]/,$d' $lab > "$scratch/short.toml"
short=("$program" run "$scratch/short.toml" --set analysis.cycles=3 --quiet)

expect_code 0 "a short run" "${short[@]}" --out "$scratch/ok"
[ -s "$scratch/ok/summary.json" ] && [ -s "$scratch/ok/cycles.csv" ] || fail "results are missing"

expect_code 2 "no verb" "$program"
expect_code 2 "an unknown option" "$program" run $lab --no-such-option
expect_code 2 "an override of an unknown key" "$program" run $lab --set span.lenght_m=3
expect_said "span.length_m"
expect_code 2 "an override out of bounds" "$program" check $lab --set span.length_m=-3
expect_said "--set span.length_m=-3"
expect_code 2 "what contradicts itself" "${short[@]}" --out "$scratch/refused" --set span.dimension=spatial --set span.condense_axial=true
expect_said "span.condense_axial"

expect_code 4 "a missing case" "$program" run "$scratch/none.toml"
expect_said "none.toml"
touch "$scratch/file"
expect_code 4 "a results folder that cannot be made" "${short[@]}" --out "$scratch/file/below"
expect_said "$scratch/file"
expect_code 4 "a report of nothing" "$program" report "$scratch/nothing"

expect_code 3 "a bound that breaks" "${short[@]}" --out "$scratch/bound" --set integrator.steps_per_cycle=40 \
  --set analysis.cycles=30 --set integrator.max_numerical_share=1e-3
expect_said "integrator.steps_per_cycle ="
grep -q '"status": "failed"' "$scratch/bound/summary.json" || fail "the broken bound is not in summary.json"
named=$(sed -n 's/.*steps_per_cycle = \([0-9]*\) would hold it.*/\1/p' "$scratch/said")
expect_code 0 "the steps that a broken bound names" "${short[@]}" --out "$scratch/held" --set integrator.steps_per_cycle="$named" \
  --set analysis.cycles=30 --set integrator.max_numerical_share=1e-3

cat "$scratch/short.toml" - > "$scratch/strict.toml" <<'EOF'
[accept]
"steady.antinode_amplitude_m" = { above = 1.0, reason = "cannot hold" }
EOF
sed -i 's/^cycles = .*/cycles = 3/' "$scratch/strict.toml"
expect_code 3 "an acceptance that fails" "$program" run "$scratch/strict.toml" --out "$scratch/strict"
expect_said "FAILED"
expect_code 0 "an acceptance of another case" "$program" run "$scratch/strict.toml" --set analysis.cycles=4 --out "$scratch/strict"
expect_said "do not decide"
finish
