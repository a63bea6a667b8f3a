#!/usr/bin/env bash
# refused.sh PROGRAM CASE: `check`, `describe` and `run` must end with exit code 2 and the same words, in which every
# phrase of a line `# refuses: ...` stands; and there is no folder of results then.
program=$1
case_file=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0
fail() {
  printf 'FAILED: %s\n' "$1"
  failures=1
}
said=$("$program" check "$case_file" 2>&1)
code=$?
[ "$code" -eq 2 ] || fail "check: exit code $code where 2 was due"
for verb in describe "run --out $folder/results"; do
  again=$("$program" $verb "$case_file" 2>&1)
  code=$?
  [ "$code" -eq 2 ] || fail "$verb: exit code $code where 2 was due"
  [ "$again" = "$said" ] || fail "$verb says something else: $again"
done
[ ! -e "$folder/results" ] || fail "a folder of results is left"
while IFS= read -r phrase; do
  case "$said" in
    *"$phrase"*) ;;
    *) fail "not said: $phrase" ;;
  esac
done < <(sed -n 's/^# refuses: //p' "$case_file")
[ "$failures" -eq 0 ] || printf 'said: %s\n' "$said"
exit "$failures"
