# Sourced by the house checks: which tree they look at and which files it has.
# shellcheck shell=bash

# The tree to check: the argument, or the one this file lives in.
enter_tree() {
  cd "${1:-$(dirname "${BASH_SOURCE[0]}")/..}" || exit 2
}

# Prints the files of the current tree, one per line and relative to it: tracked or not yet, but not the ignored ones.
# A tree that is not the top of a git work tree is listed as it lies on the disk.
list_files() {
  local git=(git -c core.quotePath=false -c "safe.directory=$(pwd -P)")  # the clone may belong to another user than the one who checks it
  if [[ "$("${git[@]}" rev-parse --show-toplevel 2>/dev/null)" == "$(pwd -P)" ]]; then
    "${git[@]}" ls-files --cached --others --exclude-standard | while IFS= read -r file; do
      # a deleted file is still listed until its deletion is committed
      if [[ -f $file ]]; then printf "%s\n" "$file"; fi
    done
  else
    find . -name .git -prune -o -name build -prune -o -type f -print | sed 's|^\./||'
  fi | sort
}

# The same, C++ files only.
list_cpp_files() { list_files | grep -E '\.(cpp|hpp|h)$'; }
