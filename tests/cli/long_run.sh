#!/usr/bin/env bash
# A run of many cycles takes no more memory than one of fewer, and to go on from its checkpoint does not either.
. "$(dirname "$0")/support.sh"
export ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}quarantine_size_mb=1  # else what is freed counts as held, where there are sanitizers
cat > "$scratch/case.toml" <<'CASE'
[section]
law = "elastic"
EA_N = 4.7e7
EI_N_m2 = 2000
mass_kg_per_m = 1.97
[span]
length_m = 3
tension_kN = 32
elements = 2
grading = "uniform"
left = "pinned"
right = "pinned"
[integrator]
method = "generalized-alpha"
rho_inf = 1
steps_per_cycle = 4
max_numerical_share = 1e6
checkpoint_every_s = 0.2
[analysis]
type = "decay"
mode = 1
antinode_amplitude_mm = 0.1
cycles = 20000
CASE

# memory_of ARGUMENTS...: $memory, the most that a run has held. [kB]
memory_of() {
  "$program" run "$scratch/case.toml" --quiet --out "$scratch/out" "$@" > "$scratch/said" 2>&1 < /dev/null &
  local job=$! now
  memory=0
  while now=$(sed -n 's/^VmHWM:[^0-9]*\([0-9]*\).*/\1/p' "/proc/$job/status" 2> /dev/null) && [ -n "$now" ]; do
    memory=$now
    [ -z "${stop_at:-}" ] || [ ! -s "$scratch/out/checkpoint.bin" ] ||
      [ "$(wc -l < "$scratch/out/cycles.csv")" -lt "$stop_at" ] || kill -KILL $job
    sleep 0.02
  done 2> /dev/null
  wait $job 2> /dev/null
  local code=$? wanted=0
  [ -z "${stop_at:-}" ] || wanted=137
  [ "$code" -eq $wanted ] || { fail "exit code $code where $wanted was due"; cat "$scratch/said"; }
}

# Some thousands are over before the first look on a busy machine.
memory_of
few=$memory
memory_of --set analysis.cycles=100000
many=$memory
stop_at=60000
memory_of --set analysis.cycles=100000
stop_at=
memory_of --set analysis.cycles=100000 --resume
resumed=$memory
echo "$few kB for 20000 cycles, $many kB for 100000, $resumed kB for the rest of them"
# 50 MB for a million cycles are 4 MB for 80 000 more; and the last look at a run may miss what it takes at its end (4 MB). The
# record of a cycle alone, kept for all of them, would be 11 MB.
allowed=$((few + 4000 + 4000))
[ "$few" -gt 0 ] && [ "$many" -gt 0 ] && [ "$resumed" -gt 0 ] || fail "no memory was measured"
[ "$many" -le $allowed ] || fail "memory grows with the cycles"
[ "$resumed" -le $allowed ] || fail "a resumed run takes more memory"
grep -q '"recomputed": {' "$scratch/out/summary.json" || fail "the summary does not say what was computed twice"
finish
