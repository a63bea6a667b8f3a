#!/usr/bin/env bash
# Long work of any kind answers SIGINT and SIGTERM within two seconds. A run ends with exit code 130 and keeps what there is;
# describe writes nothing and is ended by the signal itself (SIGTERM here: a script's background work does not hear SIGINT). A
# check has no long work.
. "$(dirname "$0")/support.sh"

span='[span]\nlength_m = 40\ntension_rts = 0.2\n'
wires() { printf '[conductor]\ncatalogue = "curlew"\nfriction = 0.5\n[section]\nlaw = "%s"\npoints = 36\n' "$1"; }

# write_case KIND: what takes minutes.
write_case() {
  case $1 in
    modes) wires return-map; printf "$span"'elements = 20000\n[analysis]\ntype = "modes"\ncount = 400\n' ;;
    static)
      wires return-map
      printf "$span"'elements = 2000\n[[load]]\ntype = "static-force"\nat_m = 20\nforce_N = 2000\n'
      printf '[analysis]\ntype = "static"\nsteps = 5000\n' ;;
    periodic)
      wires compliant
      printf "$span"'elements = 400\n[[load]]\ntype = "harmonic-force"\nat_m = 0.7\namplitude_N = 40\nfrequency = "mode 40"\n'
      printf '[analysis]\ntype = "sweep"\nrelative_width = 0.03\n' ;;
    transient)
      wires return-map
      printf "$span"'elements = 2000\n[[load]]\ntype = "harmonic-force"\nat_m = 0.7\namplitude_N = 40\nfrequency_Hz = 20\n'
      printf '[integrator]\nstep_s = 1e-5\n[analysis]\ntype = "transient"\nduration_s = 100\n' ;;
    forced)
      wires return-map
      printf "$span"'elements = 2000\n[[load]]\ntype = "harmonic-force"\nat_m = 0.7\namplitude_N = 40\nfrequency = "mode 40"\n'
      printf '[analysis]\ntype = "forced"\ncycles = 1000\n' ;;
    section)
      wires compliant
      printf '[analysis]\ntype = "section"\ntension_rts = [0.2]\ncurvature_amplitudes_per_m = [0.01, 0.02]\n'
      printf 'steps_per_cycle = 4000000\n' ;;
    mode-500)
      wires return-map
      printf '[span]\nlength_m = 10\ntension_rts = 0.2\nelements = 40000\n'
      printf '[integrator]\nstep = "auto"\n[analysis]\ntype = "decay"\nmode = 500\nantinode_amplitude_mm = 1e-3\ncycles = 1\n' ;;
    damper)
      wires compliant
      printf '[analysis]\ntype = "damper"\npoints_per_octave = 100\nelements = 100\n'
      printf '[[analysis.arm]]\nlength_m = 0.5\nmass_kg = 5\ninertia_kg_m2 = 0.05\n' ;;
    study/*)
      wires compliant
      printf "$span"'elements = 2000\n[analysis]\ntype = "self-damping"\nmethod = "%s"\n' "${1#study/}"
      case $1 in
        study/quadrature)  # a table for each of 61 tensions
          printf 'frequencies_Hz = [%s]\ntensions_rts = [%s]\n' "$(seq -s, 10 60)" "$(seq -s, 0.1 0.005 0.4)" ;;
        *) printf 'modes = [40, 60]\ntensions_rts = [0.15, 0.2, 0.25]\n' ;;
      esac
      printf 'antinode_amplitude_mm = [1, 2, 3]\n' ;;
  esac
}

# stops VERB KIND SIGNAL AFTER: the exit code, and the time that the answer took.
stops() {
  local verb=$1 kind=$2 signal=$3 after=$4 begin took code
  write_case "$kind" > "$scratch/case.toml"
  rm -rf "$scratch/out"
  local arguments=("$verb" "$scratch/case.toml")
  [ "$verb" = run ] && arguments+=(--quiet --out "$scratch/out")
  "$program" "${arguments[@]}" > "$scratch/said" 2>&1 < /dev/null &
  local job=$!
  sleep "$after"
  kill -0 $job 2> /dev/null || { fail "$verb $kind has ended before it was stopped"; cat "$scratch/said"; return; }
  begin=${EPOCHREALTIME/[.,]/}
  kill "-$signal" $job
  wait $job
  code=$?
  took=$(((${EPOCHREALTIME/[.,]/} - begin) / 1000))
  echo "$verb $kind, $signal after $after s: exit code $code after $took ms"
  local wanted=130
  [ "$verb/$signal" = run/TERM ] || [ "$signal" = INT ] || wanted=143
  [ $code -eq $wanted ] || { fail "$verb $kind: exit code $code where $wanted was due"; cat "$scratch/said"; }
  # Two seconds of a machine that has nothing else to do.
  [ $took -le 4000 ] || fail "$verb $kind takes $took ms to stop"
  [ "$verb" != run ] || grep -q '"status": "interrupted"' "$scratch/out/summary.json" ||
    fail "$verb $kind leaves no summary that says it was interrupted"
}

stops run modes INT 1.5
stops run static TERM 1
stops run periodic INT 1
stops run transient TERM 1
stops run forced INT 0.5
stops run section TERM 0.5
stops run damper TERM 1
stops run study/quadrature INT 1
stops run study/transient TERM 1
stops run study/periodic INT 1
stops run mode-500 INT 1
stops describe mode-500 TERM 0.5
finish
