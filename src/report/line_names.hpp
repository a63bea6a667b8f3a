#pragma once
/// \file The names of lines that values set apart.

#include <string>
#include <vector>

#include "strandyn/results/table.hpp"

namespace strandyn::report {

/// For each group the values that differ, with their units: "24.4 kN, ±0.05 1/m". A number without a unit ("loop 3") is
/// left out where the others tell the lines apart; a single group is named by all values that have a unit.
std::vector<std::string> names_of(const results::Groups& groups, const std::vector<std::string>& columns);

}  // namespace strandyn::report
