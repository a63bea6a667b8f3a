#!/usr/bin/env bash
# A study in shards and together again has the bytes of one that was never divided, but for clocks; what does not belong
# together or is not complete is refused, in words.
. "$(dirname "$0")/support.sh"
program=$(readlink -f "$program")

small_study "1, 3" > "$scratch/methods.toml"
cat >> "$scratch/methods.toml" <<'CASE'
[accept]
"points[4].self_damping_W_per_m" = { above = 0, reason = "it slips" }
CASE
cat > "$scratch/tables.toml" <<'CASE'
title = "tables of three tensions"
[conductor]
catalogue = "curlew"
friction = 0.5
[section]
law = "compliant"
points = 12
[analysis]
type = "self-damping"
method = "quadrature"
frequencies_Hz = [10, 20, 40]
amplitude_over_diameter = [0.05, 0.1, 0.3]
tensions_rts = [0.15, 0.2, 0.25]
[[analysis.energy_balance]]
wind = "cigre"
self_damping = "quadrature"
CASE
cat > "$scratch/bench.toml" <<'CASE'
[conductor]
catalogue = "curlew"
friction = 0.5
[section]
law = "return-map"
points = 12
[span]
length_m = 6
elements = 24
mass = "consistent"
[analysis]
type = "self-damping"
method = "transient"
modes = [3]
antinode_amplitude_mm = [1, 2]
tensions_rts = 0.2
CASE
cat > "$scratch/base.toml" <<'CASE'
[section]
law = "multilinear"
EA_N = 4.7e7
EI_N_m2 = 400
mass_kg_per_m = 1.97
[[section.spring]]
stiffness_N_m2 = 900
yield_per_m = 0.002
[span]
length_m = 8
tension_kN = 30
elements = 40
[integrator]
method = "generalized-alpha"
steps_per_cycle = 50
[analysis]
type = "decay"
mode = 3
antinode_amplitude_mm = 6
cycles = 2
CASE
cat > "$scratch/tradeoff.toml" <<'CASE'
[analysis]
type = "tradeoff"
base = "base.toml"
quantity = "cycles[sum].friction_dissipation_J"
[[analysis.knob]]
key = "span.elements"
values = [10, 20, 40]
[[analysis.knob]]
key = "integrator.method"
values = ["ida", "generalized-alpha"]
CASE
# Settings that fail: beyond buckling there are no modes; and two that each do, but not both together.
cat > "$scratch/strut.toml" <<'CASE'
[section]
law = "elastic"
EA_N = 4.7e7
EI_N_m2 = 400
mass_kg_per_m = 1.97
[span]
length_m = 8
tension_kN = 0
elements = 20
right = "roller"
[[load]]
type = "static-force"
at_m = 8
force_N = 10
direction = [-1, 0, 0]
[analysis]
type = "modes"
count = 3
CASE
cat > "$scratch/failing.toml" <<'CASE'
[analysis]
type = "tradeoff"
base = "strut.toml"
quantity = "modes[0].frequency_Hz"
[[analysis.knob]]
key = "span.elements"
values = [10, 20]
[[analysis.knob]]
key = "load[0].force_N"
values = [3000, 10]
CASE
sed -n '1,/^quantity/p' "$scratch/tradeoff.toml" > "$scratch/refused.toml"
cat >> "$scratch/refused.toml" <<'CASE'
[[analysis.knob]]
key = "span.tension_kN"
values = [250, 30]
[[analysis.knob]]
key = "section.EA_N"
values = [4e5, 4.7e7]
CASE
sed 's/^quantity.*/quantity = "steady.no_such_number"/' "$scratch/tradeoff.toml" > "$scratch/nothing.toml"

# whole NAME [ARGUMENT...], shard NAME I/N [ARGUMENT...], merge NAME I/N...: each in a folder of its own.
folder() { printf '%s/%s.%s' "$scratch" "$1" "${2//\//-of-}"; }
whole() { expect_code 0 "$1, undivided" "$program" run "$scratch/$1.toml" --quiet --out "$(folder "$1" whole)" "${@:2}"; }
shard() { "$program" run "$scratch/$1.toml" --quiet --out "$(folder "$1" "$2")" --shard "$2" "${@:3}"; }
merge() {
  local name=$1 folders=() which
  shift
  for which; do folders+=("$(folder "$name" "$which")"); done
  "$program" merge --quiet --out "$(folder "$name" merged)" "${folders[@]}"
}

# What a file says, but for clocks: those of summaries, and the column of CPU seconds of a tradeoff.
without_times() {
  case $1 in
    *.json) sed '/"wall_s"\|"cpu_s"/d' "$1" ;;
    *tradeoff.csv) awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "cpu_s") c = i } { $c = ""; print }' "$1" ;;
    *) cat "$1" ;;
  esac
}
files_of() { (cd "$1" && find . -type f | sort); }
expect_same() {
  local a b file
  a=$(folder "$1" "$2") b=$(folder "$1" "$3")
  diff <(files_of "$a") <(files_of "$b") || fail "$1: other files in $3 than in $2"
  for file in $(files_of "$a"); do
    diff <(without_times "$a/$file") <(without_times "$b/$file") > "$scratch/difference" ||
      { fail "$1, $3 against $2: other $file"; head -5 "$scratch/difference"; }
  done
}

divided() {  # NAME N: whole, in N shards that come in any order, merged
  local i all=()
  whole "$1"
  for ((i = $2; i >= 1; --i)); do
    expect_code 0 "$1, shard $i of $2" shard "$1" "$i/$2"
    all+=("$i/$2")
  done
  expect_code 0 "$1, merged" merge "$1" "${all[@]}"
  expect_same "$1" whole merged
}
divided methods 3
divided tables 3
divided bench 2
divided tradeoff 4
divided failing 2
grep -q unstable "$(folder failing merged)/summary.json" || fail "no setting has failed beyond buckling"
divided refused 3
grep -q 'would stretch the span' "$(folder refused merged)/summary.json" || fail "no setting was refused"
[ -e "$(folder tables 1/3)/summary.json" ] || fail "a shard leaves no summary"
grep -q '"own": ' "$(folder tables 1/3)/summary.json" || fail "the summary of a shard does not say which points are its own"

# A reference without the quantity ends the undivided study at once; the shards do not know of it, the merge does.
expect_code 3 "nothing to measure, undivided" "$program" run "$scratch/nothing.toml" --quiet --out "$(folder nothing whole)"
for i in 1 2; do expect_code 0 "nothing to measure, shard $i" shard nothing "$i/2"; done
expect_code 3 "nothing to measure, merged" merge nothing 1/2 2/2
diff <(without_times "$(folder nothing whole)/summary.json") <(without_times "$(folder nothing merged)/summary.json") ||
  fail "other words about a reference without the quantity"

# One point to a shard; more shards than points are refused.
for i in 1 2 3 4 5 6; do expect_code 0 "one point" shard methods "$i/6"; done
for i in 1 2 3 4 5 6; do
  [ "$(grep -c '"row"' "$(folder methods "$i/6")/points.jsonl")" -eq 1 ] || fail "shard $i/6 has not one point of six"
done
expect_code 2 "seven shards of six points" shard methods 1/7
expect_said "the study has 6 points; give no more shards than that"

# Merged again, over what is there; the program's own folder names.
expect_code 0 "merged again" merge methods 1/3 2/3 3/3
expect_same methods whole merged
mkdir "$scratch/here"
for i in 1 2; do (cd "$scratch/here" && expect_code 0 "a shard by its name" "$program" run ../bench.toml --quiet --shard $i/2); done
(cd "$scratch/here" && "$program" merge --quiet results/bench.shard-*) || fail "shards of the program's own names do not merge"
[ -e "$scratch/here/results/bench/summary.json" ] || fail "no results/bench after a merge without --out"

# An acceptance speaks of the whole study: a shard does not judge it, the merged study does, and with --set as a run.
sed 's/above = 0/below = 0/' "$scratch/methods.toml" > "$scratch/broken.toml"
for i in 1 2; do expect_code 0 "a shard of a case that breaks its acceptance" shard broken "$i/2"; done
expect_code 3 "a merged study that breaks its acceptance" merge broken 1/2 2/2
for i in 1 2; do expect_code 0 "a shard with --set" shard broken "$i/2" --set conductor.friction=0.4; done
expect_code 0 "a merged study with --set" merge broken 1/2 2/2
grep -q '"friction": 0.4' "$(folder broken merged)/summary.json" || fail "--set is lost in the merged study"

# What is no shard.
for wrong in 0/3 4/3 1/0 1 1/2/3 a/b -1/3 1/ /2 "" "1 /3"; do
  [ -z "$wrong" ] || { expect_code 2 "--shard $wrong" shard tables "$wrong"; expect_said "--shard"; }
done
expect_code 2 "shard 4 of 3" shard tables 4/3
expect_said "there is no such shard; 3 shards have the numbers 1 to 3"
[ ! -e "$(folder tables 4/3)" ] || fail "a refused shard leaves a folder"
expect_code 2 "check of a shard" "$program" check "$scratch/tables.toml" --shard 1/99
expect_said "the study has 27 points"
expect_code 2 "a shard of a decay" "$program" run "$scratch/base.toml" --shard 1/2 --out "$scratch/decay"
expect_said "run it without --shard"
expect_code 2 "a shard of a sweep" "$program" run cases/self_damping/curlew_sweep.toml --shard 1/2 --out "$scratch/sweep"
expect_said "each point of a sweep begins at the one before it"

# What does not belong together.
expect_code 2 "a folder that is no shard's" merge tables 1/3 whole
expect_said "there is no shard.json in it"
expect_code 2 "a shard that is missing" merge tables 1/3 3/3
expect_said "shard 2/3 is not given: points 10-18; run it with --shard 2/3"
expect_code 2 "a shard given twice" merge tables 1/3 2/3 1/3
expect_said "are both shard 1/3: their shares overlap; give one of them"
expect_code 0 "another division" shard tables 2/2
expect_code 2 "two divisions" merge tables 1/3 2/2
expect_said "their shares overlap"
cp -r "$(folder tables 3/3)" "$scratch/tables.other"
expect_code 0 "another case" shard tables 3/3 --set conductor.friction=0.4
expect_code 2 "two cases" merge tables 1/3 2/3 3/3
expect_said "are shards of different cases: conductor."
rm -r "$(folder tables 3/3)"
mv "$scratch/tables.other" "$(folder tables 3/3)"
cp "$(folder tables 3/3)/shard.json" "$scratch/note"
sed 's/"program": "strandyn [^ ]* /"program": "strandyn 0.0.9 /' "$scratch/note" > "$(folder tables 3/3)/shard.json"
expect_code 2 "another program" merge tables 1/3 2/3 3/3
expect_said "was computed by strandyn 0.0.9"
for damage in 's/"shard": 3/"shard": 9/' 's/"of": 3/"of": 900000000000000/' 's/self-damping/modes/' 's/"of"/"off"/' 's/{/[/' '/text/d'; do
  sed "$damage" "$scratch/note" > "$(folder tables 3/3)/shard.json"
  expect_code 2 "a damaged note ($damage)" merge tables 1/3 2/3 3/3
done
cp "$scratch/note" "$(folder tables 3/3)/shard.json"
expect_code 2 "a merge into a shard" "$program" merge "$(folder tables 1/3)" "$(folder tables 2/3)" "$(folder tables 3/3)" \
  --out "$(folder tables 2/3)"
expect_said "give another one for the merged study with --out"
expect_code 2 "another shard in the same folder" "$program" run "$scratch/tables.toml" --shard 2/3 --resume \
  --out "$(folder tables 1/3)"
expect_said "it is the folder of shard 1/3"
expect_code 2 "no folders" "$program" merge
sed -i 's/= 40/= 41/' "$scratch/base.toml"
expect_code 2 "another base than the shards had" merge tradeoff 1/4 2/4 3/4 4/4
expect_said "were computed from other files beside the case than lie there now"
sed -i 's/= 41/= 40/' "$scratch/base.toml"

# A damaged point is missing, and is computed again by who has it.
sed -i '0,/"row"/s/"self_damping_W_per_m":[0-9.e+-]*/"self_damping_W_per_m":123.0/' "$(folder tables 2/3)/points.jsonl"
expect_code 2 "a damaged point" merge tables 1/3 2/3 3/3
expect_said "lacks 1 of its 9 points: "
expect_code 0 "the shard with the damaged point" shard tables 2/3 --resume
expect_code 0 "merged after that" merge tables 1/3 2/3 3/3
expect_same tables whole merged

# A setting that was lost is named; a shard that was killed goes on.
rm "$(folder tradeoff 2/4)/settings/001.json"
expect_code 2 "a lost setting" merge tradeoff 1/4 2/4 3/4 4/4
expect_said "lacks 1 of its 2 settings: 2"
expect_code 0 "the shard that has lost it" shard tradeoff 2/4 --resume
expect_code 0 "all settings" merge tradeoff 1/4 2/4 3/4 4/4
expect_same tradeoff whole merged

points=$(folder methods 1/2)/points.jsonl
STRANDYN_CORES=1 "$program" run "$scratch/methods.toml" --quiet --out "$(folder methods 1/2)" --shard 1/2 > "$scratch/said" 2>&1 &
job=$!
while kill -0 $job 2> /dev/null && ! grep -qs '"row"' "$points"; do sleep 0.01; done
kill -KILL $job 2> /dev/null
wait $job 2> /dev/null
expect_code 0 "the other shard" shard methods 2/2
kept=$(grep -c '"row"' "$points")
if [ "$kept" -lt 3 ]; then
  expect_code 2 "a merge while a shard is not complete" merge methods 1/2 2/2
  expect_said "shard 1/2 ($(folder methods 1/2)) lacks $((3 - kept)) of its 3 points"
  expect_said "go on with --shard 1/2 --resume"
else
  fail "the shard was not killed in the middle"
fi
expect_code 0 "the shard goes on" shard methods 1/2 --resume
expect_code 0 "merged after a kill" merge methods 1/2 2/2
expect_same methods whole merged

# The undivided study takes over the folder of a shard, with its points; it is no shard's any more.
cp -r "$(folder tables 1/3)" "$(folder tables taken)"
expect_code 0 "all in the folder of a shard" "$program" run "$scratch/tables.toml" --quiet --resume --out "$(folder tables taken)"
[ ! -e "$(folder tables taken)/shard.json" ] || fail "the whole study calls itself a shard"
cmp -s "$(folder tables whole)/points.jsonl" "$(folder tables taken)/points.jsonl" || fail "other points after a shard's"
finish
