#!/usr/bin/env bash
# Every command of docs/how_to.md from an empty folder, as it stands there. A block of TOML is a file of the name in its
# first line.
source "$(dirname "$0")/support.sh"

page=$(cd "$(dirname "$0")/../.." && pwd)/docs/how_to.md
mkdir "$scratch/empty" "$scratch/bin"
ln -s "$(readlink -f "$program")" "$scratch/bin/strandyn"
cd "$scratch/empty" || exit 1
awk '/^```toml$/ { getline name; sub(/^# /, "", name); file = name; next }
     /^```$/ { file = "" }
     file { print > file }' "$page"
awk '/^```sh$/ { on = 1; next } /^```$/ { on = 0 } on' "$page" > ../commands
jobs=$(grep -c '^## [0-9]' "$page")
[ "$jobs" -eq 9 ] || fail "$jobs jobs where nine are told"
count=$(grep -c 'strandyn ' ../commands)
[ "$count" -ge 15 ] || fail "only $count commands found"
PATH=$scratch/bin:$PATH bash -euo pipefail ../commands > ../said 2>&1 < /dev/null ||
  { fail "a command of the page fails"; tail -n 20 ../said; }
for file in *.toml; do
  "$program" check "$file" > ../said 2>&1 || { fail "$file is refused"; cat ../said; }
done
finish
