#!/usr/bin/env bash
# kills.sh PROGRAM: runs are ended by SIGKILL, SIGTERM or SIGINT at random moments, again and again, each time taken up by
# --resume; what they leave in the end is, to the byte, what an undisturbed run leaves, but for what the clock says and for
# `recomputed`. Decays and forced vibrations, both integrators, every section law; studies by every method.
# STRANDYN_KILLS: how many kills (10); a kind of run gets at least one, five in a row where there are many. Only those
# count that have really ended a run. STRANDYN_KILL_SEED: of the moments, the signals, and of the kinds where not all
# get one (1).
. "$(dirname "$0")/support.sh"
kills=${STRANDYN_KILLS:-10} seed=${STRANDYN_KILL_SEED:-1}
echo "STRANDYN_KILLS=$kills STRANDYN_KILL_SEED=$seed"
RANDOM=$seed

wires() { printf '[conductor]\ncatalogue = "curlew"\nfriction = 0.5\n[section]\nlaw = "%s"\npoints = 12\n' "$1"; }
elastic='EA_N = 4.7e7\nEI_N_m2 = 1500\nmass_kg_per_m = 1.97\n'
section() {
  case $1 in
    elastic) printf "[section]\nlaw = \"elastic\"\n$elastic" ;;
    multilinear)
      printf "[section]\nlaw = \"multilinear\"\n$elastic"
      printf '[[section.spring]]\nstiffness_N_m2 = 90\nyield_per_m = %s\n' 0.0005 0.001 0.002 ;;
    *) wires "$1" ;;
  esac
}

# write_case KIND: a run of some tenths of a second, and some checkpoints or points in it.
write_case() {
  IFS=/ read -r what law method <<< "$1"
  if [ "$what" = study ]; then
    wires return-map
    printf '[span]\nlength_m = 6\nelements = 12\n'
    local amplitudes='4, 6, 8' tensions='0.15, 0.2'
    case $law in
      transient)
        printf '[[load]]\ntype = "harmonic-force"\nat_m = 0.7\namplitude_N = 1\nfrequency = "mode 2"\n'
        printf '[integrator]\nsteps_per_cycle = 40\nmethod = "generalized-alpha"\n'
        printf '[analysis]\nmodes = 2\n'
        amplitudes='2, 3' tensions=0.15 ;;
      periodic)
        printf '[analysis]\nmodes = 2\n'
        amplitudes='1, 2' ;;
      *) printf '[analysis]\nfrequencies_Hz = [%s]\n' "$(seq -s, 20 0.25 60)" ;;
    esac
    printf 'type = "self-damping"\nmethod = "%s"\nantinode_amplitude_mm = [%s]\ntensions_rts = [%s]\n' \
      "$law" "$amplitudes" "$tensions"
    return
  fi
  local cycles=150
  case $law in return-map | masing) cycles=60 ;; compliant) cycles=15 ;; esac
  section "$law"
  printf '[span]\nlength_m = 6\ntension_kN = 20\nelements = 12\n'
  printf '[integrator]\nmethod = "%s"\nsteps_per_cycle = 50\ncheckpoint_every_s = 0.03\nmax_numerical_share = 1e3\n' "$method"
  if [ "$what" = decay ]; then
    printf '[analysis]\ntype = "decay"\nmode = 2\nantinode_amplitude_mm = 6\ncycles = %s\n' "$cycles"
  else
    printf '[[load]]\ntype = "harmonic-force"\nat_m = 0.7\namplitude_N = 60\ndirection = [0, 1, 0]\nfrequency = "mode 2"\n'
    printf '[analysis]\ntype = "forced"\ncycles = %s\n' "$cycles"
  fi
}

# IDA keeps its state with some versions of SUNDIALS only.
methods="ida generalized-alpha"
write_case decay/elastic/ida > "$scratch/probe.toml"
"$program" run "$scratch/probe.toml" --set analysis.cycles=1 --quiet --out "$scratch/probe" > /dev/null 2>&1 < /dev/null ||
  methods=generalized-alpha
kinds=()
for law in stick slip elastic multilinear masing return-map compliant; do
  for method in $methods; do kinds+=("decay/$law/$method" "forced/$law/$method"); done
done
for method in quadrature periodic transient foti-2018; do kinds+=("study/$method"); done

# draw BELOW: $drawn. Not through $( ), where the shell has a RANDOM of its own.
draw() { drawn=$(((RANDOM << 15 | RANDOM) % $1)); }
milliseconds() { echo $((${EPOCHREALTIME/[.,]/} / 1000)); }

# The summary without what differs.
comparable() { sed '/^  "recomputed": {/,/^  }/d; /"wall_s"\|"cpu_s"/d' "$1/summary.json"; }

# expect_same WHAT: the folders have the same files, and these the same bytes.
expect_same() {
  diff <(ls -A "$scratch/whole") <(ls -A "$scratch/killed") > "$scratch/difference" ||
    { fail "$1: other files"; cat "$scratch/difference"; }
  diff <(comparable "$scratch/whole") <(comparable "$scratch/killed") > "$scratch/difference" ||
    { fail "$1: other summary.json"; head -5 "$scratch/difference"; }
  local path
  for path in "$scratch/whole"/*; do
    [ "${path##*/}" = summary.json ] || cmp -s "$path" "$scratch/killed/${path##*/}" || fail "$1: other ${path##*/}"
  done
}

# kill_run SIGNAL MILLISECONDS: starts or resumes the run and ends it after so long. 0 where the signal did it.
kill_run() {
  "$program" run "$scratch/case.toml" --quiet --resume --out "$scratch/killed" > "$scratch/said" 2>&1 < /dev/null &
  local job=$!
  sleep "$(printf '%d.%03d' $(($2 / 1000)) $(($2 % 1000)))"
  kill "-$1" $job 2> /dev/null
  wait $job 2> /dev/null
  case $?/$1 in
    137/KILL | 143/TERM | 130/TERM | 130/INT) return 0 ;;
    0/*) return 1 ;;
    *) fail "$kind: the run ended in another way"; cat "$scratch/said"; return 1 ;;
  esac
}

declare -A ended=([KILL]=0 [TERM]=0 [INT]=0)
counted=0
signals=(KILL TERM INT)

# kill_often KIND TIMES
kill_often() {
  kind=$1
  write_case "$kind" > "$scratch/case.toml"
  rm -rf "$scratch/whole" "$scratch/killed"
  local begin took
  begin=$(milliseconds)
  expect_code 0 "$kind, undisturbed" "$program" run "$scratch/case.toml" --quiet --out "$scratch/whole"
  took=$(($(milliseconds) - begin + 1))
  local done=0 tries=0 signal
  while [ $done -lt "$2" ] && [ $tries -lt $((20 * $2)) ] && [ "$failures" -eq 0 ]; do
    tries=$((tries + 1))
    draw 3
    signal=${signals[drawn]}
    draw "$took"
    if kill_run "$signal" "$drawn"; then
      done=$((done + 1)) ended[$signal]=$((ended[$signal] + 1))
    elif [ "$failures" -eq 0 ]; then  # it came to its end before
      expect_same "$kind, after $done kills"
      rm -rf "$scratch/killed"
    fi
  done
  [ $done -eq "$2" ] || fail "$kind: only $done of $2 kills have ended a run"
  counted=$((counted + done))
  expect_code 0 "$kind, resumed" "$program" run "$scratch/case.toml" --quiet --resume --out "$scratch/killed"
  expect_same "$kind, after $done kills"
}

# Shuffled, where not all kinds get a kill.
for ((i = ${#kinds[@]} - 1; i > 0; --i)); do
  draw $((i + 1))
  kept=${kinds[i]} kinds[i]=${kinds[drawn]} kinds[drawn]=$kept
done
each=$(((kills + ${#kinds[@]} - 1) / ${#kinds[@]}))
for kind_to_kill in "${kinds[@]}"; do
  left=$((kills - counted))
  [ $left -gt 0 ] && [ "$failures" -eq 0 ] || break
  kill_often "$kind_to_kill" $((left < each ? left : each))
done
echo "$counted kills of ${#kinds[@]} kinds of run: ${ended[KILL]} by SIGKILL, ${ended[TERM]} by SIGTERM, ${ended[INT]} by SIGINT"
finish
