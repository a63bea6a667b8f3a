#!/usr/bin/env bash
# A folder never mixes the results of two analyses: what the earlier one left goes.
. "$(dirname "$0")/support.sh"
sed '/^\[accept\]/,$d' cases/curlew_lab_span.toml > "$scratch/case.toml"
expect_code 0 "a forced vibration with its page" "$program" run "$scratch/case.toml" --set analysis.cycles=3 --report --out "$scratch/out" --quiet
for file in cycles.csv dissipation_profile.csv energy_per_cycle.svg report.html; do
  [ -s "$scratch/out/$file" ] || fail "$file is missing"
done
touch "$scratch/out/notes.txt"
expect_code 0 "modes into the same folder" "$program" run cases/curlew_modes.toml --out "$scratch/out" --quiet
for file in cycles.csv dissipation_profile.csv energy_per_cycle.svg report.html; do
  [ -e "$scratch/out/$file" ] && fail "$file of the earlier run is still there"
done
[ -s "$scratch/out/modes.csv" ] || fail "modes.csv is missing"
[ -e "$scratch/out/notes.txt" ] || fail "a file that no run wrote was taken away"
finish
