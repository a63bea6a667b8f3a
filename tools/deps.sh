# Sourced by tools/run, tools/test and .ci/run: the Debian packages of the build, and their installation.
# shellcheck shell=bash

say() { printf 'strandyn: %s\n' "$*" >&2; }

# One line per package: its name and the proof that it is in place. A program counts wherever the PATH finds it.
# A library counts when dpkg knows its package as installed or, on a system without dpkg, when its header is found.
list_packages() {
  cat <<'TABLE'
g++                 program g++
cmake               program cmake
ninja-build         program ninja
libeigen3-dev       header  eigen3/Eigen/Core
libsundials-dev     header  ida/ida.h
libfmt-dev          header  fmt/format.h
libtomlplusplus-dev header  toml++/toml.h
libcli11-dev        header  CLI/CLI.hpp
nlohmann-json3-dev  header  nlohmann/json.hpp
libhwy-dev          header  hwy/highway.h
libspectra-dev      header  Spectra/SymEigsSolver.h
doctest-dev         header  doctest/doctest.h
TABLE
}

# Prints the packages that are not in place, one per line.
list_missing_packages() {
  local package kind proof installed=""
  if command -v dpkg-query >/dev/null; then
    # shellcheck disable=SC2046  # one argument per package is what is wanted
    installed=$(dpkg-query -W -f '<${Package}:${db:Status-Status}>' $(list_packages | cut -d' ' -f1) 2>/dev/null) || true
  fi
  while read -r package kind proof; do
    if [[ $kind == program ]]; then
      command -v "$proof" >/dev/null || echo "$package"
    elif command -v dpkg-query >/dev/null; then
      [[ $installed == *"<$package:installed>"* ]] || echo "$package"
    else
      [[ -e /usr/include/$proof || -e /usr/local/include/$proof ]] || echo "$package"
    fi
  done < <(list_packages)
}

# Installs what is missing. Returns 69 ("a service is unavailable", sysexits.h) where that is not possible.
install_missing_packages() {
  local missing as_root=() log by_hand
  mapfile -t missing < <(list_missing_packages)
  ((${#missing[@]})) || return 0

  by_hand="apt-get update && apt-get install -y --no-install-recommends ${missing[*]}"
  if ! command -v apt-get >/dev/null; then
    say "these packages are missing: ${missing[*]}"
    say "these are Debian's names and there is no apt-get here; please install what they stand for and try again"
    return 69
  fi
  if [[ $(id -u) != 0 ]]; then
    if ! sudo -n true 2>/dev/null; then
      say "these packages are missing, and only root can install them: ${missing[*]}"
      say "please run this once, then try again:"
      if command -v sudo >/dev/null; then
        printf "\n  sudo sh -c '%s'\n\n" "$by_hand" >&2
      else
        printf "\n  su -c '%s'\n\n" "$by_hand" >&2
      fi
      return 69
    fi
    as_root=(sudo -n)
  fi

  say "installing ${#missing[@]} packages and what they need (a few minutes): ${missing[*]}"
  log=$(mktemp)
  # An update that fails is no reason to stop: the package lists may already be good enough. Another apt-get may
  # be at work: wait for its lock.
  if ! { "${as_root[@]}" apt-get update ||
         echo "apt-get update failed; the installation is tried with the package lists at hand"
         "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
           apt-get install -y --no-install-recommends -o DPkg::Lock::Timeout=600 "${missing[@]}"; } \
       >"$log" 2>&1 </dev/null; then
    cat "$log" >&2
    rm -f "$log"
    say "the installation failed (above: why). By hand, as root: $by_hand"
    return 69
  fi
  rm -f "$log"
}
