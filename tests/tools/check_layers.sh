#!/usr/bin/env bash
# usage: check_layers.sh SCENARIO
source "$(dirname "$0")/support.sh"

put tools/layers.txt <<'T'
# level module
0  core    # below
2  beam    # in the middle
2  section # beside beam
5  solver  # above
T
put include/strandyn/core/error.hpp <<<'#include <string>'
put src/beam/element.cpp <<'T'
#include "strandyn/beam/element.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/version.hpp"
#include "local.hpp"
// #include "strandyn/solver/solve.hpp" is only talked about here
T

case $1 in
  downward) accepted check_layers ;;
  upward)
    put include/strandyn/beam/element.hpp <<<$'#pragma once\n#  include "strandyn/solver/solve.hpp"'
    refused check_layers \
      'include/strandyn/beam/element.hpp:2: beam (level 2) includes "strandyn/solver/solve.hpp" (level 5)'
    ;;
  sideways)
    put src/section/law.cpp <<<'#include <strandyn/beam/element.hpp>'
    refused check_layers 'src/section/law.cpp:1: section (level 2) includes "strandyn/beam/element.hpp" (level 2)'
    ;;
  climbing)
    put src/section/law.cpp <<<'#include "../beam/local.hpp"'
    refused check_layers 'src/section/law.cpp:1: "../beam/local.hpp" climbs out of its folder'
    ;;
  unknown)
    put src/extra/thing.cpp <<<'int thing;'
    refused check_layers 'src/extra/thing.cpp:1: unknown module extra'
    put src/beam/other.cpp <<<'#include "strandyn/gone/x.hpp"'
    refused check_layers 'src/beam/other.cpp:1: "strandyn/gone/x.hpp" names no module'
    ;;
  sundials)
    put src/solver/ida.cpp <<<'#include <ida/ida.h>'
    accepted check_layers
    put include/strandyn/solver/ida.hpp <<<'#include <sundials/sundials_context.h>'
    refused check_layers 'include/strandyn/solver/ida.hpp:1: "sundials/sundials_context.h" is a header of SUNDIALS'
    ;;
  table)
    put tools/layers.txt <<<'core 0'
    refused check_layers 'tools/layers.txt:1: expected a level and a module'
    ;;
  *) fail "no such scenario: $1" ;;
esac
