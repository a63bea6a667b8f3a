#pragma once
/// \file A case as a list of paths and values, to say in which key two of them differ.

#include <map>
#include <optional>
#include <string>

#include "strandyn/results/value.hpp"

namespace strandyn::study {

/// Every number and word of a case by its path, "analysis.modes.1".
using FlatCase = std::map<std::string, std::string>;
FlatCase flat_case(const results::Value& as_run);

/// A key in which two cases differ, with both values; "not given" where it is absent.
struct KeyDifference {
  std::string key, first, second;
};
/// The first of them, or nothing.
std::optional<KeyDifference> first_difference(const FlatCase& first, const FlatCase& second);

}  // namespace strandyn::study
