#!/usr/bin/env bash
# Every command of docs/tutorial.md and docs/how_to.md from an empty folder, as it stands there. A block of TOML is a file of the name in its
# first line.
source "$(dirname "$0")/support.sh"

docs=$(cd "$(dirname "$0")/../.." && pwd)/docs
mkdir "$scratch/bin"
ln -s "$(readlink -f "$program")" "$scratch/bin/strandyn"

# try_page NAME COMMANDS: so many at least.
try_page() {
  local page=$docs/$1.md count file
  mkdir "$scratch/$1"
  cd "$scratch/$1" || exit 1
  awk '/^```toml$/ { getline name; sub(/^# /, "", name); file = name; next }
       /^```$/ { file = "" }
       file { print > file }' "$page"
  awk '/^```sh$/ { on = 1; next } /^```$/ { on = 0 } on' "$page" > ../commands
  count=$(grep -c 'strandyn ' ../commands)
  [ "$count" -ge "$2" ] || fail "$1: only $count commands found"
  PATH=$scratch/bin:$PATH bash -euo pipefail ../commands > ../said 2>&1 < /dev/null ||
    { fail "a command of $1 fails"; tail -n 20 ../said; }
  for file in *.toml; do
    "$scratch/bin/strandyn" check "$file" > ../said 2>&1 || { fail "$1: $file is refused"; cat ../said; }
  done
}

try_page tutorial 3
try_page how_to 15
[ "$(grep -c '^## [0-9]' "$docs/how_to.md")" -eq 9 ] || fail "not nine jobs"
finish
