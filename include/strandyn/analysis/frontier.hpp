#pragma once
/// \file What a computation costs and how far it is off: the settings that no other one beats, and the cheapest for a
/// target.

#include <optional>
#include <span>
#include <vector>

namespace strandyn::analysis {

struct Trade {
  double cost = 0;   ///< any unit
  double error = 0;  ///< [-] size, without a sign
};

/// Of each, whether no other one is both as cheap and as near, and better in one of the two.
std::vector<bool> frontier(std::span<const Trade> trades);

/// The number of the cheapest whose error, together with `unsure` of what it was measured against, is at most `target`.
std::optional<std::size_t> cheapest(std::span<const Trade> trades, double target, double unsure);

}  // namespace strandyn::analysis
