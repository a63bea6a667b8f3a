// Runs a case file and prints its summary: all that a program needs to use strandyn as a library.
#include <cstdio>
#include <strandyn/casefile/read.hpp>
#include <strandyn/results/json.hpp>
#include <strandyn/study/run_case.hpp>

int main(int count, char** arguments) {
  if (count != 2) return std::fputs("usage: summary CASE.toml\n", stderr), 2;
  const auto result = strandyn::study::run_case(strandyn::casefile::read_scene(arguments[1]));
  std::puts(strandyn::results::to_text(result.summary).c_str());
}
