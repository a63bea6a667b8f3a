#!/usr/bin/env bash
# extending.sh SOURCE: the examples of docs/extending.md, one patch each, are applied to a copy of the tree. Each may add
# three files and change two. The copy is built, and the case that each patch brings must pass.
set -euo pipefail
source_tree=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT

tar -C "$source_tree" --exclude=./build --exclude=./results --exclude=./.git -cf - . | tar -C "$copy" -xf -
for patch in "$here"/*.patch; do
  name=$(basename "$patch")
  new=$(grep -c '^--- /dev/null' "$patch")
  changed=$(($(grep -c '^diff ' "$patch") - new))
  echo "$name: $new new files, $changed changed"
  ((new <= 3 && changed <= 2)) || { echo "FAILED: $name touches too many files"; exit 1; }
  patch --quiet -d "$copy" -p1 < "$patch" || { echo "FAILED: $name does not fit the tree any more"; exit 1; }
done
# No optimization: it is the building that is tried.
cmake -S "$copy" -B "$copy/build" -G Ninja -DCMAKE_BUILD_TYPE= -DCMAKE_CXX_FLAGS=-O0 > "$copy/log" || { cat "$copy/log"; exit 1; }
cmake --build "$copy/build" --target strandyn > "$copy/log" || { tail -n 40 "$copy/log"; exit 1; }
cd "$copy"
failures=0
for case_file in cases/extending/*.toml; do
  build/strandyn run "$case_file" --out "build/$(basename "$case_file" .toml)" && continue
  echo "FAILED: $case_file"
  failures=$((failures + 1))
done
exit "$((failures > 0))"
