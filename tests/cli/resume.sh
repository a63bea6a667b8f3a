#!/usr/bin/env bash
# A run that was killed goes on from its last checkpoint, and ends with the bytes of one that was never interrupted.
. "$(dirname "$0")/support.sh"
sed '/^\[accept\]/,$d' cases/curlew_lab_span.toml > "$scratch/case.toml"
checkpoint() { printf '%s/checkpoint.bin' "$scratch/$1"; }

# without_times FOLDER: the summary but for what the clock says, and what a run that went on says of itself.
without_times() {
  sed '/^  "recomputed": {/,/^  }/d; /"wall_s"\|"cpu_s"/d' "$scratch/$1/summary.json"
}

# expect_same FOLDER FOLDER WHAT
expect_same() {
  diff <(without_times "$1") <(without_times "$2") > "$scratch/difference" ||
    { fail "$3: other summary.json"; head -5 "$scratch/difference"; }
  local table
  for table in cycles.csv dissipation_profile.csv; do
    cmp -s "$scratch/$1/$table" "$scratch/$2/$table" || fail "$3: other $table"
  done
}

# IDA keeps its state with some versions of SUNDIALS only; with the others it says so.
methods="ida generalized-alpha"
if ! "$program" run "$scratch/case.toml" --set analysis.cycles=1 --set integrator.checkpoint_every_s=1000 --quiet \
  --out "$scratch/probe" > "$scratch/said" 2>&1 < /dev/null; then
  methods=generalized-alpha
  expect_said 'method = "generalized-alpha"'
fi

for method in $methods; do
  run=("$program" run "$scratch/case.toml" --set analysis.cycles=60 --set "integrator.method=$method"
       --set integrator.checkpoint_every_s=0.05 --quiet)
  expect_code 0 "$method, uninterrupted" "${run[@]}" --out "$scratch/$method-whole"
  [ -e "$(checkpoint $method-whole)" ] && fail "$method: a finished run leaves its checkpoint"

  # Killed after its first checkpoint, and after the first of the resumed run: in the middle, wherever that is.
  for resume in "" --resume; do
    "${run[@]}" --out "$scratch/$method" $resume > "$scratch/said" 2>&1 < /dev/null &
    job=$!
    touch "$scratch/started"
    while kill -0 $job 2> /dev/null && [ ! "$(checkpoint $method)" -nt "$scratch/started" ]; do sleep 0.02; done
    kill -KILL $job 2> /dev/null
    wait $job 2> /dev/null
    [ -s "$(checkpoint $method)" ] || fail "$method: no checkpoint of the killed run"
    [ -e "$scratch/$method/summary.json" ] && fail "$method: it was not killed in the middle"
  done
  cp "$(checkpoint $method)" "$scratch/kept.bin"
  expect_code 0 "$method, resumed" "${run[@]}" --out "$scratch/$method" --resume
  expect_same $method-whole $method "$method, resumed"
  grep -q '"recomputed": {' "$scratch/$method/summary.json" || fail "$method: not said what was computed twice"
  grep -q '"recomputed": {' "$scratch/$method-whole/summary.json" && fail "$method: said of a run that was not resumed"
  [ -e "$(checkpoint $method)" ] && fail "$method: the checkpoint stays after the end"
done

# Ctrl-C keeps a checkpoint too, however seldom they are due.
run=("$program" run "$scratch/case.toml" --set analysis.cycles=200 --set integrator.checkpoint_every_s=1000
     --set "integrator.method=${methods%% *}")
"${run[@]}" --out "$scratch/stopped" > "$scratch/said" 2>&1 < /dev/null &
job=$!
until [ -d "$scratch/stopped" ]; do sleep 0.02; done
sleep 0.3  # from here on it obeys
kill -INT $job
wait $job
[ $? -eq 130 ] || fail "not interrupted"
[ -s "$(checkpoint stopped)" ] || fail "no checkpoint after Ctrl-C"
expect_code 0 "after Ctrl-C" "${run[@]}" --out "$scratch/stopped" --resume
expect_said "resuming from $(checkpoint stopped)"
expect_code 0 "nothing to resume from" "${run[@]}" --set analysis.cycles=2 --out "$scratch/new" --resume
expect_said "there is no $(checkpoint new)"

# refused CODE FILE WORDS: the run does not resume from the file, and says why.
refused() {
  cp "$2" "$(checkpoint new)"
  expect_code "$1" "a checkpoint to refuse" "${run[@]}" --set analysis.cycles=2 --out "$scratch/new" --resume
  expect_said "$3"
  expect_said "$(checkpoint new)"
}
refused 2 "$scratch/kept.bin" "another case: "
refused 4 cases/curlew_lab_span.toml "no checkpoint of strandyn"
head -c 5000 "$scratch/kept.bin" > "$scratch/bad.bin"
refused 4 "$scratch/bad.bin" "cut off"
{ head -c 5000 "$scratch/kept.bin"; printf 'xx'; tail -c +5003 "$scratch/kept.bin"; } > "$scratch/bad.bin"
refused 4 "$scratch/bad.bin" "damaged"
finish
