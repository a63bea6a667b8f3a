# Sourced by tools/run, tools/test and .ci/run: the Debian packages of the build, and their installation.
# shellcheck shell=bash

# Of SUNDIALS one small static library is used. Its package, installed, brings MPI, PETSc, HYPRE and a Fortran compiler,
# 200 packages and 700 MB; so it is only unpacked here, where cmake/sundials.cmake finds it.
sundials_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)/build/deps/sundials

say() { printf 'strandyn: %s\n' "$*" >&2; }

# One line per package: its name and the proof that it is in place. A program counts wherever the PATH finds it.
# A library counts when dpkg knows its package as installed or, on a system without dpkg, when its header is found; one
# that needs no installation also when it was unpacked.
list_packages() {
  cat <<'TABLE'
g++                 program g++
cmake               program cmake
ninja-build         program ninja
libeigen3-dev       header  eigen3/Eigen/Core
libsundials-dev     archive ida/ida.h
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
    elif [[ $kind == archive && -e $sundials_folder/include/$proof ]]; then
      continue
    elif command -v dpkg-query >/dev/null; then
      [[ $installed == *"<$package:installed>"* ]] || echo "$package"
    else
      [[ -e /usr/include/$proof || -e /usr/local/include/$proof ]] || echo "$package"
    fi
  done < <(list_packages)
}

# with_signs LOG COUNT COMMAND...: keeps what the command says in LOG and says itself, every few seconds, how far apt-get
# is with what COUNT names.
with_signs() {
  local log=$1 count=$2 began=$SECONDS ticker code=0
  shift 2
  : >"$log"
  while sleep "${STRANDYN_SIGN_S:-5}" >/dev/null 2>&1 && kill -0 $$; do
    say "  $((SECONDS - began)) s, $count: $(grep -c '^Get:' "$log") fetched," \
      "$(grep -c '^Unpacking ' "$log") unpacked, $(grep -c '^Setting up ' "$log") set up"
  done &
  ticker=$!
  "$@" >"$log" 2>&1 </dev/null || code=$?
  kill "$ticker" 2>/dev/null || true
  wait "$ticker" 2>/dev/null || true
  return "$code"
}

# Reads what apt-get would do and prints "COUNT packages, SIZE to fetch, SIZE on the disk"; nothing where it says nothing.
read_simulation() {
  awk '/ newly installed/ { count = $1 + $3 }
       /^Need to get / { fetched = $0; sub(/^Need to get /, "", fetched); sub(/( of |\/).*/, "", fetched) }
       /^After this operation, / { disk = $4 " " $5 }
       END { if (count) printf "%d packages, %s to fetch, %s on the disk\n", count, fetched, disk }'
}

# install_packages LOG AS_ROOT... -- PACKAGE...
install_packages() {
  local log=$1 as_root=() simulated
  local apt_install=(apt-get install --no-install-recommends -o DPkg::Lock::Timeout=600)
  shift
  while [[ $1 != -- ]]; do as_root+=("$1"); shift; done
  shift
  simulated=$("${as_root[@]}" env LC_ALL=C "${apt_install[@]}" --assume-no "$@" 2>/dev/null </dev/null |
    read_simulation) || true
  say "installing with what they need (${simulated:-apt-get does not say how much}): $*"
  with_signs "$log" "${simulated%%,*}" "${as_root[@]}" env LC_ALL=C DEBIAN_FRONTEND=noninteractive \
    "${apt_install[@]}" -y "$@"
}

# unpack_sundials LOG: the headers and the static archive of IDA, from the package as Debian signed it. Needs no root.
unpack_sundials() {
  local log=$1 new=$sundials_folder.new bytes
  bytes=$(apt-get --print-uris -qq download libsundials-dev 2>/dev/null </dev/null | awk '{ print $3 }') || true
  say "fetching libsundials-dev, $(awk -v b="$bytes" 'BEGIN { printf "%.1f", b / 1e6 }') MB, to be unpacked below build/deps"
  rm -rf "$new" "$sundials_folder"
  mkdir -p "$new/lib"
  {
    (cd "$new" && apt-get download libsundials-dev) </dev/null &&
      dpkg-deb --fsys-tarfile "$new"/*.deb | tar -x -C "$new" --strip-components=2 ./usr/include &&
      dpkg-deb --fsys-tarfile "$new"/*.deb | tar -x -C "$new/lib" --strip-components=4 --wildcards '*/libsundials_*.a' &&
      find "$new/lib" -type f ! -name libsundials_ida.a ! -name libsundials_core.a -delete
  } >"$log" 2>&1 || return
  rm -f "$new"/*.deb
  mv "$new" "$sundials_folder"
}

# Installs what is missing. Returns 69 ("a service is unavailable", sysexits.h) where that is not possible.
install_missing_packages() {
  local missing packages=() as_root=() log by_hand update=(apt-get update) failed=""
  mapfile -t missing < <(list_missing_packages)
  ((${#missing[@]})) || return 0

  if ! command -v apt-get >/dev/null; then
    say "these packages are missing: ${missing[*]}"
    say "these are Debian's names and there is no apt-get here; please install what they stand for and try again"
    return 69
  fi
  mapfile -t packages < <(printf '%s\n' "${missing[@]}" | grep -vx libsundials-dev)
  by_hand="apt-get update"
  if ((${#packages[@]})); then by_hand+=" && apt-get install -y --no-install-recommends ${packages[*]}"; fi
  if [[ $(id -u) != 0 ]]; then
    if sudo -n true 2>/dev/null; then
      as_root=(sudo -n)
    elif ((${#packages[@]})); then
      say "these packages are missing, and only root can install them: ${packages[*]}"
      say "please run this once, then try again:"
      say_by_hand "$by_hand"
      return 69
    else
      update=()
    fi
  fi

  log=$(mktemp)
  # An update that fails is no reason to stop: the package lists may already be good enough. Another apt-get may be at
  # work: its lock is waited for.
  if ((${#update[@]})); then
    say "reading the package lists (apt-get update)"
    with_signs "$log" "package lists" "${as_root[@]}" "${update[@]}" ||
      say "apt-get update failed; the package lists at hand are tried"
  fi
  if ((${#packages[@]})); then install_packages "$log" "${as_root[@]}" -- "${packages[@]}" || failed=yes; fi
  if [[ -z $failed && " ${missing[*]} " == *" libsundials-dev "* ]]; then unpack_sundials "$log" || failed=yes; fi
  if [[ -n $failed ]]; then
    cat "$log" >&2
    rm -f "$log"
    say "the installation failed (above: why). As root, by hand, then try again:"
    say_by_hand "$by_hand"
    return 69
  fi
  rm -f "$log"
}

say_by_hand() {
  if command -v sudo >/dev/null; then
    printf "\n  sudo sh -c '%s'\n\n" "$1" >&2
  else
    printf "\n  su -c '%s'\n\n" "$1" >&2
  fi
}

# What the program builds without and its tests skip: fields of a run (HDF5) and the Python package. Tried, and that is all.
install_what_is_optional() {
  local as_root=()
  command -v apt-get >/dev/null || return 0
  if [[ $(id -u) != 0 ]]; then
    sudo -n true 2>/dev/null || return 0
    as_root=(sudo -n)
  fi
  "${as_root[@]}" env LC_ALL=C DEBIAN_FRONTEND=noninteractive apt-get install --no-install-recommends -y \
    libhdf5-dev python3-numpy python3-h5py mkdocs >/dev/null 2>&1 </dev/null ||
    say "without libhdf5-dev and python3-numpy: what they are for is not tested"
}
