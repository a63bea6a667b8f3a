# Sourced by tools/run, tools/test and .ci/run after tools/deps.sh: configure and build below build/release.
# Everything is printed to standard error, and nothing where there is nothing to do.
# shellcheck shell=bash

# How many compilers or tests run at once: the cores this process may use, unless the caller set CMake's variable.
count_jobs() { echo "${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"; }

# build ROOT PRESET TARGET: the presets `release` and `ci` share the folder build/release and what was compiled there.
# Returns 70 ("internal software error", sysexits.h) when the program does not configure or compile.
build() {
  local root=$1 preset=$2 target=$3 folder=$1/build/release log fresh=()
  # A folder tree that was copied from elsewhere still points to its old home and must not build that one.
  if [[ ! -e $folder/build.ninja ]] || ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
    fresh=(--fresh)  # this drops objects too
  fi
  if [[ $preset == ci || ${#fresh[@]} != 0 ]]; then
    say "configuring $folder"
    log=$(mktemp)
    if ! (cd "$root" && cmake "${fresh[@]}" --preset "$preset") >"$log" 2>&1 </dev/null; then
      cat "$log" >&2
      rm -f "$log"
      say "CMake could not configure (above: why)"
      return 70
    fi
    rm -f "$log"
  fi
  # ninja says what it does; its words for "nothing to do" are left out.
  if ! (set -o pipefail
        cmake --build "$folder" --target "$target" --parallel "$(count_jobs)" 2>&1 </dev/null |
          { grep --line-buffered -v -e '^ninja: no work to do' -e 'Re-checking globbed directories' || true; }) >&2; then
    say "the build failed (above: the compiler's words)"
    return 70
  fi
}
