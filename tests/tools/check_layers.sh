#!/usr/bin/env bash
# usage: check_layers.sh SCENARIO
source "$(dirname "$0")/support.sh"

put tools/layers.txt <<'T'
# level module: uses
0 core:                # below
2 beam: core           # in the middle
2 section:             # beside beam
5 solver/static: beam  # above
5 solver/time: core    # beside it
T
put include/strandyn/core/error.hpp <<<'#include <string>'
put src/beam/element.cpp <<'T'
#include "strandyn/beam/element.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/version.hpp"
#include "local.hpp"
// #include "strandyn/solver/solve.hpp" is only talked about here
T
put src/solver/static/path.cpp <<<'#include "strandyn/beam/element.hpp"'
put src/solver/time/step.cpp <<<'#include "strandyn/core/error.hpp"'

case $1 in
  downward) accepted check_layers ;;
  upward)
    put tools/layers.txt <<'T'
0 core:
2 beam: core solver/static
5 solver/static: beam
5 solver/time: core
T
    put include/strandyn/beam/element.hpp <<<$'#pragma once\n#  include "strandyn/solver/static/solve.hpp"'
    refused check_layers 'tools/layers.txt:2: beam (level 2) uses solver/static (level 5)'
    ;;
  sideways)
    put src/section/law.cpp <<<'#include <strandyn/beam/element.hpp>'
    refused check_layers 'src/section/law.cpp:1: section includes "strandyn/beam/element.hpp"'
    ;;
  missing)
    put src/solver/time/step.cpp <<<$'#include "strandyn/core/error.hpp"\n#include "strandyn/solver/static/path.hpp"'
    refused check_layers 'src/solver/time/step.cpp:2: solver/time includes "strandyn/solver/static/path.hpp"'
    ;;
  unused)
    put src/solver/static/path.cpp <<<'#include <vector>'
    refused check_layers 'solver/static names beam and includes nothing of it'
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
    put src/solver/time/ida.cpp <<<'#include <ida/ida.h>'
    accepted check_layers
    put src/solver/static/path.cpp <<<$'#include "strandyn/beam/element.hpp"\n#include <sundials/sundials_context.h>'
    refused check_layers 'src/solver/static/path.cpp:2: "sundials/sundials_context.h" is a header of SUNDIALS'
    ;;
  json)
    put tools/layers.txt <<'T'
0 core:
1 results:
2 beam: core
2 section:
5 solver/static: beam
5 solver/time: core
T
    put src/results/json.cpp <<<'#include <nlohmann/json.hpp>'
    accepted check_layers
    put src/section/law.cpp <<<'#include <nlohmann/json.hpp>'
    refused check_layers 'src/section/law.cpp:1: "nlohmann/json.hpp": JSON is read and written in src/results/json.cpp'
    ;;
  table)
    put tools/layers.txt <<<'core 0'
    refused check_layers 'tools/layers.txt:1: expected a level, a module, a colon'
    ;;
  *) fail "no such scenario: $1" ;;
esac
