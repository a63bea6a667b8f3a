#!/usr/bin/env bash
# What the shell may do to the program: standard streams that cannot be written, a reader that goes away, words that
# would steer a terminal, damaged points of a study, files that a kill has left, long tables.
. "$(dirname "$0")/support.sh"
sed -e '/^\[accept\]/,$d' -e 's/^cycles = .*/cycles = 2/' cases/curlew_lab_span.toml > "$scratch/case.toml"

# refused COMMAND...: exit code 4 where standard output is full, and where it is closed.
refused() {
  "$@" > /dev/full 2> "$scratch/said"
  [ $? -eq 4 ] || fail "full standard output: $*"
  expect_said "cannot write to standard output"
  "$@" >&- 2> /dev/null
  [ $? -eq 4 ] || fail "closed standard output: $*"
}
for verb in --help --version conductors "conductors curlew" schema "schema --results" "check $scratch/case.toml" \
  "describe $scratch/case.toml" "describe $scratch/case.toml --json"; do
  refused "$program" $verb
done
for form in --json ""; do
  refused "$program" run "$scratch/case.toml" $form --out "$scratch/unprinted$form"
  [ -s "$scratch/unprinted$form/summary.json" ] && [ -s "$scratch/unprinted$form/cycles.csv" ] ||
    fail "the results are not on disk where they cannot be printed"
done
"$program" schema 2> "$scratch/said" | head -1 > /dev/null
[ "${PIPESTATUS[0]}" -eq 4 ] && [ ! -s "$scratch/said" ] || fail "a reader that goes away does not end the program quietly"

"$program" check "$scratch/none.toml" 2>&-
[ $? -eq 4 ] || fail "closed standard error changes the exit code"
"$program" check "$scratch/none.toml" 2> /dev/full
[ $? -eq 4 ] || fail "full standard error changes the exit code"
"$program" run "$scratch/case.toml" --out "$scratch/unheard" > "$scratch/tables" 2>&-
[ $? -eq 0 ] && [ -s "$scratch/unheard/summary.json" ] || fail "closed standard error ends a run"
"$program" run "$scratch/case.toml" --out "$scratch/unheard2" > "$scratch/tables2" 2> /dev/full
[ $? -eq 0 ] && cmp -s "$scratch/tables" "$scratch/tables2" || fail "full standard error ends a run"

{ echo 'title = "\u001b[31mred\u009b1m"'; sed '/^title/d' "$scratch/case.toml"; } > "$scratch/title.toml"
expect_code 0 "a title with escapes" "$program" check "$scratch/title.toml"
expect_said '\x1b[31mred\x9b1m'
expect_code 2 "a name with escapes" "$program" conductors $'\x1b[31mx'
grep -q $'\x1b' "$scratch/said" && fail "an escape reaches the terminal"
expect_code 2 "a name with a quote" "$program" conductors 'a"b'
expect_said "the catalogue holds"
cp "$scratch/case.toml" "$scratch/"$'\xff\xfe.toml'
expect_code 0 "a file name that is no UTF-8" "$program" run "$scratch/"$'\xff\xfe.toml' --report --out "$scratch/"$'\xff'

mkdir "$scratch/parts"
touch "$scratch/parts/.checkpoint.bin.4194999.part" "$scratch/parts/.checkpoint.bin.$$.part" "$scratch/parts/.mine.part"
expect_code 0 "a folder with left-overs" "$program" run "$scratch/case.toml" --out "$scratch/parts"
[ ! -e "$scratch/parts/.checkpoint.bin.4194999.part" ] || fail "what a kill has left stays"
[ -e "$scratch/parts/.checkpoint.bin.$$.part" ] || fail "what another program writes is taken away"
[ -e "$scratch/parts/.mine.part" ] || fail "a file of the user is taken away"

cp -r "$scratch/unheard" "$scratch/broken"
for text in '{"title": 1e999}' "$(printf '{"a":%.0s' {1..5000})1"; do
  echo "$text" > "$scratch/broken/summary.json"
  expect_code 2 "a summary that is none" "$program" report "$scratch/broken"
  expect_said "run the case again"
done

cat > "$scratch/study.toml" <<'CASE'
[conductor]
catalogue = "curlew"
friction = 0.5
[section]
law = "compliant"
[analysis]
type = "self-damping"
method = "quadrature"
frequencies_Hz = [10, 20]
amplitude_over_diameter = [0.05, 0.1]
tensions_rts = 0.2
CASE
study=("$program" run "$scratch/study.toml" --out "$scratch/study" --quiet)
without_times() { sed '/^  "recomputed": {/,/^  }/d; /"wall_s"\|"cpu_s"/d' "$scratch/study/summary.json"; }
expect_code 0 "a study" "${study[@]}"
without_times > "$scratch/whole"
cp "$scratch/study/points.jsonl" "$scratch/points"
# resumed WARNED DAMAGE: the log as a kill leaves it, with one thing changed.
resumed() {
  sed -e "$2" -e /finished/d "$scratch/points" > "$scratch/study/points.jsonl"
  expect_code 0 "a damaged point ($2)" "${study[@]}" --resume
  [ "$1" = no ] || expect_said "computed again"
  without_times | cmp -s - "$scratch/whole" || fail "a damaged point is in the results: $2"
}
resumed no 's/^//'
[ ! -s "$scratch/said" ] || fail "a log without damage is warned of"
resumed yes '2s/"row":{.*}}/"row":{}}/'
resumed yes '2s/.$//'
resumed yes '2s/"point":0/"point":99/'
resumed yes '3s/"self_damping_W_per_m":[0-9.e+-]*/"self_damping_W_per_m":123.0/'
resumed yes '2s/.*/[[[[[[[[/'
resumed yes '4s/.*//'
resumed yes '1s/study/stud/'
resumed yes '5s/"frequency_Hz":[0-9.]*/"frequency_Hz":7.0/'
resumed yes '6s/"onset_per_m":[0-9.e+-]*/"onset_per_m":0.5/'
resumed yes '6s/"table":{.*}}/"table":{}}/'
sed -e '2s/"self_damping_W_per_m":[0-9.e+-]*/"self_damping_W_per_m":123.0/' -e /finished/d "$scratch/points" \
  > "$scratch/study/points.jsonl"
expect_code 0 "without --resume" "${study[@]}"
without_times | cmp -s - "$scratch/whole" || fail "points are taken up without --resume"

# A shaker record of 40 000 rows on one line; a second is far more than it takes.
{
  sed -e '/^\[\[load/,$d' -e '/^\[initial/,$d' -e '/^\[analysis/,$d' "$scratch/case.toml" > /dev/null
  printf '[conductor]\ncatalogue = "curlew"\n[span]\nlength_m = 10\ntension_rts = 0.2\nelements = 30\n[[load]]\n'
  printf 'type = "table"\nat_m = 1\nhistory = ['
  awk 'BEGIN { for (i = 0; i < 40000; ++i) printf "[%.4f, %.1f], ", i * 1e-4, (i * 37 % 101) / 10 }'
  printf '[4.5, %s]]\n[integrator]\nstep_s = 2e-4\n[analysis]\ntype = "transient"\nduration_s = 0.1\n' 0
} > "$scratch/long.toml"
expect_code 0 "a long table" timeout 5 "$program" check "$scratch/long.toml"
sed 's/\[4.5, 0\]/[4.5, "x"]/' "$scratch/long.toml" > "$scratch/wrong.toml"
expect_code 2 "a long table with a slip" timeout 10 "$program" check "$scratch/wrong.toml"
expect_said 'load[0].history[40000][1] = "x": must be a number'
[ "$(wc -c < "$scratch/said")" -lt 400 ] || fail "the refusal of a long table quotes all of it"
finish
