#!/usr/bin/env bash
# usage: check_words.sh SCENARIO
source "$(dirname "$0")/support.sh"

# Words with a slash that name no folder of a machine; put together here, so that this file does not contain them.
folder=root
put README.md <<T
Energies (stored/work/dissipated), https://doi.org/10.1000/$folder/x, \${$folder}/$folder/x and ~/home/x are no folders.
T

case $1 in
  clean) accepted check_words ;;
  path)
    for folder in work/main root/.cache home/anna/src tmp/build-x; do
      put src/x.cpp <<<$'//\nauto f = "/'"$folder"'";'
      refused check_words "src/x.cpp:2:\"/$folder"
    done
    ;;
  server)
    for host in deb.''debian.org/debian pypi.''org/simple eu-python.pkg.''dev/p; do
      put tools/x.txt <<<"from http://$host now"
      refused check_words "tools/x.txt:1:http://$host"
    done
    ;;
  binary)
    printf 'a\0b\n/%s/x\n' root | put data.bin
    accepted check_words
    ;;
  *) fail "no such scenario: $1" ;;
esac
