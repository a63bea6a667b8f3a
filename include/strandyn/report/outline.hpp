#pragma once
/// \file A tree of results as an outline for a terminal: names and values with their units, a heading for each group.

#include <string>

#include "strandyn/results/value.hpp"

namespace strandyn::report {

std::string text_of(const results::Value& object);

}  // namespace strandyn::report
