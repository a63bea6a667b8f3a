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

# small_study AMPLITUDES: self-damping of a short span by three methods, in seconds.
small_study() {
  cat <<CASE
[conductor]
catalogue = "curlew"
[section]
law = "return-map"
[span]
length_m = 6
elements = 32
mass = "consistent"
[analysis]
type = "self-damping"
method = "periodic"
mode_shape = "clamped"
modes = [3, 4]
antinode_amplitude_mm = [$1]
tensions_rts = 0.2
[[analysis.at]]
mode = 4
antinode_amplitude_mm = 3
tension_rts = 0.2
method = "quadrature"
[[analysis.at]]
mode = 4
antinode_amplitude_mm = 3
tension_rts = 0.2
method = "foti-2018"
CASE
}
