#!/usr/bin/env bash
# Conductors that one brings along, names that people mistype, and what the shell is told of the command line.
. "$(dirname "$0")/support.sh"

cat > "$scratch/rest" <<'CASE'
[span]
length_m = 30
tension_rts = 0.2
elements = 20
[analysis]
type = "modes"
count = 2
CASE

# A printed conductor is pasted above the rest of a case and run as it is.
for name in "ACSR Drake" zebra messenger-19-240; do
  "$program" conductors "$name" > "$scratch/printed.toml"
  cat "$scratch/printed.toml" "$scratch/rest" > "$scratch/pasted.toml"
  { printf '[conductor]\nfile = "printed.toml"\n'; cat "$scratch/rest"; } > "$scratch/by_file.toml"
  for case_file in pasted by_file; do
    expect_code 0 "check of $name ($case_file)" "$program" check "$scratch/$case_file.toml"
    expect_code 0 "describe of $name ($case_file)" "$program" describe "$scratch/$case_file.toml"
    "$program" run "$scratch/$case_file.toml" --quiet --json --out "$scratch/$case_file" |
      grep -A3 frequencies_Hz > "$scratch/$case_file.found"
  done
  [ -s "$scratch/pasted.found" ] && cmp -s "$scratch/pasted.found" "$scratch/by_file.found" ||
    fail "$name pasted and by file have other frequencies"
done

# Wires of a CSV file become a table, which a case takes too.
printf 'wires,diameter_mm,metal,lay_ratio\n1,3.454,ST,\n6,3.454,ST,20\n10,4.442,AL1,-13\n16,4.442,AL1,12\n' > "$scratch/w.csv"
"$program" conductors --import "$scratch/w.csv" > "$scratch/imported.toml" || fail "the import of wires"
{ cat "$scratch/imported.toml"; sed 's/tension_rts = .*/tension_kN = 20/' "$scratch/rest"; } > "$scratch/own.toml"
expect_code 0 "a case with imported wires" "$program" check "$scratch/own.toml"
sed -i 's/^6,3.454/6,thick/' "$scratch/w.csv"
expect_code 2 "a CSV with a word" "$program" conductors --import "$scratch/w.csv"
expect_said "w.csv:3:3: diameter_mm = thick: must be a number"
expect_code 4 "no CSV" "$program" conductors --import "$scratch/none.csv"

# The nearest verb, option, conductor.
expect_code 2 "a misspelt verb" "$program" runn "$scratch/own.toml"
expect_said 'there is no verb `runn`; did you mean `run`?'
expect_code 2 "a misspelt option" "$program" run "$scratch/own.toml" --jsno
expect_said '`run` has no option `--jsno`; did you mean `--json`?'
expect_code 2 "a misspelt conductor" "$program" conductors "ACSR Darke"
expect_said 'did you mean `drake`?'

# Several slips, a line each.
sed -e 's/^length_m.*/length_m = -1/' -e 's/^count.*/cuont = 2/' "$scratch/own.toml" > "$scratch/wrong.toml"
expect_code 2 "a case with two slips" "$program" check "$scratch/wrong.toml"
[ "$(grep -c '^strandyn: .*wrong.toml:[0-9]*:1: ' "$scratch/said")" -eq 2 ] || fail "two slips are not two messages"

# The completion of bash, as a shell uses it; the others as far as their shells are there.
completed() { # WORD...: what the last word of a command line becomes
  bash -c 'eval "$("$0" completion bash)"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _strandyn; echo "${COMPREPLY[*]}"' \
    "$program" "$@"
}
[ "$(completed strandyn ru)" = run ] || fail "completion of a verb"
[ "$(completed strandyn run x.toml --jso)" = --json ] || fail "completion of an option"
[ "$(completed strandyn conductors zeb)" = zebra ] || fail "completion of a conductor"
for shell in zsh fish; do
  "$program" completion "$shell" > "$scratch/completion.$shell" || fail "completion of $shell"
  grep -q zebra "$scratch/completion.$shell" || fail "the completion of $shell knows no conductors"
  if command -v "$shell" > /dev/null; then
    "$shell" -n "$scratch/completion.$shell" || fail "$shell does not read its completion"
  fi
done
expect_code 2 "a shell that is none" "$program" completion bsah
expect_said 'did you mean `bash`?'

# The manual and --help are made from the same declarations: every option of every verb stands in both.
"$program" man > "$scratch/strandyn.1" || fail "the manual"
for verb in run check describe verify conductors schema completion man report; do
  grep -q "^.SS strandyn $verb" "$scratch/strandyn.1" || fail "the manual does not know $verb"
  for option in $("$program" "$verb" --help | grep -o -- '^  --[a-z]*'); do
    grep -q -- "\\\\-\\\\-${option#--}" "$scratch/strandyn.1" || fail "the manual does not know $option of $verb"
  done
done
finish
