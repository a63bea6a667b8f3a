#!/usr/bin/env bash
# usage: check_tests.sh SCENARIO
source "$(dirname "$0")/support.sh"

put tests/beam/one.cpp <<'T'
TEST_CASE("beam: stands still") {}
TEST_CASE(
    "beam: a long name that begins on "
    "the next line") {}
// TEST_CASE("beam: stands still") was here; doctest::Approx too
TEST_CASE_TEMPLATE("beam: any scalar", T, float, double) {}
T
put tests/section/one.cpp <<<'TEST_CASE("beam: stands still") {}  // another module'

case $1 in
  clean) accepted check_tests ;;
  twice)
    put tests/beam/two.cpp <<<$'\nTEST_CASE("beam: stands still") {}'
    refused check_tests 'tests/beam/two.cpp:2: the name of this test is taken by tests/beam/one.cpp:1: beam: stands still'
    put tests/beam/two.cpp <<<'TEST_CASE("beam: a long name that begins on the next line" * doctest::timeout(1)) {}'
    refused check_tests 'tests/beam/two.cpp:1: the name of this test is taken by tests/beam/one.cpp:2'
    put tests/beam/two.cpp <<<'TEST_CASE_FIXTURE(Rig<double>, "beam: Any scalar") {}'
    refused check_tests 'tests/beam/two.cpp:1: the name of this test is taken by tests/beam/one.cpp:6'
    ;;
  approx)
    put tests/beam/two.cpp <<<$'\nCHECK(a == doctest::Approx(b));'
    refused check_tests 'tests/beam/two.cpp:2: doctest::Approx'
    put tests/beam/two.cpp <<<'CHECK(a == Approx(b));'
    refused check_tests 'tests/beam/two.cpp:1: doctest::Approx'
    ;;
  letters)
    put tests/beam/two.cpp <<<'TEST_CASE("beam: one; two") {}'
    refused check_tests 'tests/beam/two.cpp:1: a test name must do without'
    put tests/beam/two.cpp <<<'TEST_CASE("beam: x in [0, 1)") {}'
    refused check_tests 'tests/beam/two.cpp:1: the square brackets'
    put tests/beam/two.cpp <<<'TEST_CASE("beam: x in [0, 1], closed") {}'
    accepted check_tests
    put tests/beam/two.cpp <<<$'TEST_SUITE("slow") {\nTEST_CASE("beam: long, slow") {}\n}'
    refused check_tests 'tests/beam/two.cpp:2: in a file with test suites a comma'
    ;;
  *) fail "no such scenario: $1" ;;
esac
