#pragma once
/// \file What a case must show: the [accept] table, and its verdict on a summary.
///
/// The left side of an entry is a path into summary.json:
///     steady.damping_ratio    loops[1].area_J_per_m    cycles[-1].x    cycles[max].x    frequencies_Hz[sum]
/// An index counts from 0, or from the end if negative; max, min and sum run over the list. `exit_code` is that of the
/// program.

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "strandyn/results/value.hpp"

namespace strandyn::casefile {

using Scalar = std::variant<double, bool, std::string>;

/// One entry: `expected` (a number with `relative` or `absolute`), or `below`, or `above`.
struct Criterion {
  std::string path = {};
  std::optional<Scalar> expected = {};
  std::optional<double> relative = {};  ///< [-] of |expected|
  std::optional<double> absolute = {};  ///< in the unit of the quantity
  std::optional<double> below = {};
  std::optional<double> above = {};
  std::string reason = {};
  std::optional<std::string> source = {};
};

struct Acceptance {
  std::vector<Criterion> criteria;
};

struct Verdict {
  std::string path;
  std::optional<double> got;     ///< empty where the path leads to no number
  std::string found;             ///< what was found, or why nothing was
  std::string wanted;            ///< "0.0012 within 2 %"
  std::optional<double> digits;  ///< correct decimal digits, where a number was expected; 17 if equal
  bool passed = false;
  std::string reason;
  std::string source;  ///< empty where the case names none
};

/// One verdict per entry. A path that leads nowhere fails with a text; nothing is thrown.
std::vector<Verdict> judge(const Acceptance& acceptance, const results::Value& summary, int exit_code);

/// The number at a path of a summary; empty where there is none.
std::optional<double> number_at(const std::string& path, const results::Value& summary);

/// What is wrong with the spelling of a path, or nothing.
std::optional<std::string> find_path_fault(std::string_view path);

}  // namespace strandyn::casefile
