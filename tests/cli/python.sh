#!/usr/bin/env bash
# The Python package: its tests and its examples. Skipped where there is no Python with numpy.
source "$(dirname "$0")/support.sh"

python=""
for candidate in python3 /usr/bin/python3; do
  if command -v "$candidate" >/dev/null && "$candidate" -c 'import numpy, sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then
    python=$candidate
    break
  fi
done
[[ -n $python ]] || { echo "no Python 3.11 with numpy: skipped"; exit 77; }

root=$(cd "$(dirname "$0")/../.." && pwd)
export STRANDYN=$program PYTHONPATH=$root/python PYTHONDONTWRITEBYTECODE=1
cd "$scratch"
"$python" -m unittest discover -s "$root/python/tests" || fail "the tests of the package"
for example in "$root"/python/examples/*.py; do
  "$python" "$example" >"$scratch/said" 2>&1 || grep -q "^matplotlib is not installed\|^h5py is not installed" "$scratch/said" ||
    fail "$(basename "$example"): $(tail -n 5 "$scratch/said")"
done
finish
