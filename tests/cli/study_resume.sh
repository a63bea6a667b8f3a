#!/usr/bin/env bash
# A study of several roads that was killed goes on with the points that are left, and ends with the bytes of one that was
# never interrupted: summary.json but for the clock, tables and points.
. "$(dirname "$0")/support.sh"
small_study "1, 2, 3" > "$scratch/case.toml"
run=("$program" run "$scratch/case.toml" --quiet --resume)
points() { printf '%s/points.jsonl' "$scratch/$1"; }
finished_points() { grep -s '"row"' "$(points "$1")" | wc -l; }

# without_times FOLDER: the summary but for what the clock says, and what a study that went on says of itself.
without_times() { sed '/^  "recomputed": {/,/^  }/d; /"wall_s"\|"cpu_s"/d' "$scratch/$1/summary.json"; }

expect_same() {
  diff <(without_times whole) <(without_times "$1") > "$scratch/difference" ||
    { fail "$2: other summary.json"; head -5 "$scratch/difference"; }
  local file
  for file in points.jsonl points_periodic.csv points_quadrature.csv points_foti-2018.csv sectional_loss.csv; do
    cmp -s "$scratch/whole/$file" "$scratch/$1/$file" || fail "$2: other $file"
  done
}

# stop_after SIGNAL FOLDER POINTS: starts the study and ends it as soon as it has that many points.
stop_after() {
  "${run[@]}" --out "$scratch/$2" > "$scratch/said" 2>&1 < /dev/null &
  local job=$!
  while kill -0 $job 2> /dev/null && [ "$(finished_points "$2")" -lt "$3" ]; do sleep 0.01; done
  kill "-$1" $job 2> /dev/null
  wait $job 2> /dev/null
}

expect_code 0 "uninterrupted" "${run[@]}" --out "$scratch/whole"
[ "$(finished_points whole)" -eq 8 ] || fail "the study has not 8 points"

# Killed again and again, wherever it stands; each start takes up what the last one has left.
for count in 1 3 5; do
  before=$(finished_points killed)
  stop_after KILL killed "$count"
  [ "$(finished_points killed)" -ge "$before" ] || fail "a restart has lost points"
done
[ -e "$scratch/killed/summary.json" ] && fail "it was not killed in the middle"
# A line that the end of the program cut.
printf '{"point":7,"row":{"freq' >> "$(points killed)"
expect_code 0 "after kills" "${run[@]}" --out "$scratch/killed"
expect_same killed "after kills"

stop_after INT stopped 2
expect_code 0 "after Ctrl-C" "${run[@]}" --out "$scratch/stopped"
expect_same stopped "after Ctrl-C"

# Killed before its first point, with nothing but the head of the file there.
stop_after KILL early 0
expect_code 0 "after a kill at the start" "${run[@]}" --out "$scratch/early"
expect_same early "after a kill at the start"
finish
