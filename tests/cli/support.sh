# Shared by the scripts beside it. $1 of a script is the program.
set -u
program=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0

fail() {
  printf 'FAILED: %s\n' "$1"
  failures=$((failures + 1))
}

# expect_code CODE DESCRIPTION COMMAND...: the output is kept in $scratch/said.
expect_code() {
  local wanted=$1 what=$2
  shift 2
  "$@" > "$scratch/said" 2>&1 < /dev/null
  local got=$?
  [ "$got" -eq "$wanted" ] || { fail "$what: exit code $got where $wanted was due"; cat "$scratch/said"; }
}

expect_said() {
  grep -qF -- "$1" "$scratch/said" || { fail "not said: $1"; cat "$scratch/said"; }
}

finish() {
  [ "$failures" -eq 0 ]
  exit
}
