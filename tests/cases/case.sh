#!/usr/bin/env bash
# case.sh PROGRAM CASE FOLDER: a case runs and meets its [accept] table; its page has a figure, and no figure asks for a
# column that is not there; what `describe` expects it to cost holds what it cost, within a range of ten at most.
program=$1
case_file=$2
folder=$3
"$program" run "$case_file" --out "$folder" --report || exit
grep -q "<figure" "$folder/report.html" || { echo "FAILED: the page has no figure"; exit 1; }

# number KEY: of a line of JSON, the first of that key.
number() {
  sed -n "s/^ *\"$1\": \([-+.0-9e]*\),*\$/\1/p" | head -n 1
}
told=$("$program" describe "$case_file" --json) || exit
least=$(number section_evaluations_at_least <<< "$told")
most=$(number section_evaluations_at_most <<< "$told")
took=$(sed -n '/^  "cost": {/,/^  }/p' "$folder/summary.json" | number section_evaluations)
echo "section evaluations: $least to $most expected, $took taken"
awk -v least="$least" -v most="$most" -v took="$took" \
  'BEGIN { exit !(least != "" && took != "" && least <= took && took <= most && (most <= 10 * least || most == 0)) }' ||
  { echo "FAILED: describe does not expect what the case cost"; exit 1; }
