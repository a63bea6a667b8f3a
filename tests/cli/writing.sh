#!/usr/bin/env bash
# What a long run writes with the outputs that nobody asked for: below 100 bytes a step, below 3 % of its time. STRANDYN_STEPS
# makes it longer than the quick one here (a million is what the bound was set for).
. "$(dirname "$0")/support.sh"
steps=${STRANDYN_STEPS:-200000}
per_cycle=200
cat > "$scratch/case.toml" <<'CASE'
[section]
law = "elastic"
EA_N = 4.7e7
EI_N_m2 = 2000
mass_kg_per_m = 1.97
[span]
length_m = 3
tension_kN = 32
elements = 40
grading = "uniform"
left = "pinned"
right = "pinned"
[integrator]
method = "generalized-alpha"
rho_inf = 1
max_numerical_share = 1e6
CASE

# measure NAME: the case below [integrator] and [analysis] of standard input; $size in bytes, $share of its time in per cent.
measure() {
  cat "$scratch/case.toml" - > "$scratch/$1.toml"
  "$program" run "$scratch/$1.toml" --out "$scratch/$1" > "$scratch/$1.out" 2> "$scratch/$1.err" < /dev/null ||
    fail "$1: $(tail -n 3 "$scratch/$1.err")"
  size=$(cat "$scratch/$1"/* | wc -c)
  share=$(sed -n 's/^results in .*, \([0-9.e-]*\) % of the time to write)$/\1/p' "$scratch/$1.err")
  done_steps=$(sed -n 's/^ *"steps": \([0-9]*\),*$/\1/p' "$scratch/$1/summary.json" | head -n 1)
  echo "$1: $done_steps steps, $size bytes, $share % of the time"
  [ "$done_steps" -ge "$steps" ] || fail "$1: $done_steps steps where $steps were asked for"
  [ "$size" -lt $((100 * steps)) ] || fail "$1 writes $size bytes in $steps steps"
  [ -n "$share" ] || fail "$1 does not say what it took to write"
  awk -v share="${share:-100}" 'BEGIN { exit !(share < 3) }' || fail "$1 spends $share % of its time writing"
}

measure decay <<CASE
steps_per_cycle = $per_cycle
[analysis]
type = "decay"
mode = 1
antinode_amplitude_mm = 0.1
cycles = $((steps / per_cycle))
CASE

measure transient <<CASE
step_s = 0.001
[initial]
velocity_mode = 1
antinode_velocity_m_per_s = 0.01
[analysis]
type = "transient"
probes_m = [0.75, 1.5]
duration_s = $(awk -v n="$steps" 'BEGIN { print n / 1000 }')
CASE
[ "$(wc -l < "$scratch/transient/energies.csv")" -gt 20000 ] || fail "the transient keeps too few rows"
tail -n 1 "$scratch/transient/histories.csv" | grep -q "^$(awk -v n="$steps" 'BEGIN { print n / 1000 }')," ||
  fail "the last row is not the last step: $(tail -n 1 "$scratch/transient/histories.csv")"
grep -q "one in [0-9]* stands in histories.csv" "$scratch/transient.out" || fail "it does not say that rows are left out"
finish
