// The section laws against each other: what a cheaper one gives away, what it saves, and what the couplings between
// tension and bending do. Prints the tables of docs/section_ladder.md.
#include "ladder.hpp"
#include "strandyn/section/return_map.hpp"

int main() {
  const strandyn::section::VectorTarget target = strandyn::section::vector_target();
  fmt::print("Vector instructions: {} ({} doubles).\n", target.name, target.lanes);
  strandyn::bench::print_masing_tables();
  strandyn::bench::print_points_tables();
  strandyn::bench::print_cost_tables();
  strandyn::bench::print_coupling_tables();
}
