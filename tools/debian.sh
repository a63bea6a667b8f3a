# Sourced by tools/try_in_debian and tools/try_package after tools/deps.sh: a Debian that has nothing yet, in a folder.
# shellcheck shell=bash

# In spaces of their own, mounts and processes end with the command, however it ends.
alone=(unshare --mount --pid --fork --kill-child)

skip() { say "$1: nothing is tried"; exit 77; }
# Exit code 77 where no Debian can be made here.
must_make_debian() {
  [[ $(id -u) == 0 ]] || skip "not root"
  command -v debootstrap >/dev/null || skip "debootstrap is missing"
  "${alone[@]}" true 2>/dev/null || skip "this machine does not let root mount"
}

# The server that this machine's apt uses, where it is one of Debian's packages.
find_mirror() {
  # shellcheck disable=SC2016  # apt-get's own variable
  apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Origin: Debian' 'Label: Debian' 2>/dev/null | head -n 1
}

# copy_if_there FOLDER PATH...
copy_if_there() {
  local folder=$1 path
  shift
  for path in "$@"; do
    [[ -e $path ]] || continue
    rm -rf "${folder:?}$path"
    mkdir -p "$(dirname "$folder$path")"
    cp -aL "$path" "$folder$path"
  done
}

# make_debian RELEASE FOLDER: a minimal Debian with the way out of this machine. Returns 69 where debootstrap fails.
make_debian() {
  local release=$1 folder=$2 log mirror
  say "making a minimal Debian $release"
  log=$(mktemp)
  mirror=$(find_mirror) || true
  if ! debootstrap --variant=minbase "$release" "$folder" ${mirror:+"$mirror"} >"$log" 2>&1 </dev/null; then
    cat "$log" >&2
    rm -f "$log"
    say "debootstrap failed (above: why)"
    return 69
  fi
  rm -f "$log"
  copy_if_there "$folder" /etc/resolv.conf /etc/hosts /etc/ssl/certs /etc/apt/auth.conf /etc/apt/auth.conf.d
  # Of the settings only the way out: others name programs that are not in there.
  apt-config dump | grep -iE '^Acquire::(https?|ftp)::(proxy|verify|cainfo|sslcert|sslkey)' \
    >"$folder/etc/apt/apt.conf.d/10network" || true
}

# copy_tree FROM TO: the files of a source tree.
copy_tree() {
  mkdir -p "$2"
  (cd "$1" && list_files | tar -c -T - | tar -x -C "$2")
}

# in_debian FOLDER WHERE COMMAND...: runs it in that Debian, in its folder WHERE.
in_debian() {
  local folder=$1 where=$2
  shift 2
  # shellcheck disable=SC2016  # "$@" is for the shell inside
  "${alone[@]}" sh -c 'mount -t proc proc "$0/proc" && exec chroot "$0" "$@"' "$folder" \
    /usr/bin/env -C "$where" HOME=/root LC_ALL=C.UTF-8 "$@" </dev/null
}
