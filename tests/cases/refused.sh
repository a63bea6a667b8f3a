#!/usr/bin/env bash
# refused.sh PROGRAM CASE: the program must end with exit code 2 and say every phrase that a line `# refuses: ...` names.
program=$1
case_file=$2
said=$("$program" check "$case_file" 2>&1)
code=$?
if [ "$code" -ne 2 ]; then
  printf 'exit code %s where 2 was due:\n%s\n' "$code" "$said"
  exit 1
fi
missing=0
while IFS= read -r phrase; do
  case "$said" in
    *"$phrase"*) ;;
    *) printf 'not said: %s\n' "$phrase"; missing=1 ;;
  esac
done < <(sed -n 's/^# refuses: //p' "$case_file")
[ "$missing" -eq 0 ] || printf 'said: %s\n' "$said"
exit "$missing"
