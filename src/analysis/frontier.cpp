#include "strandyn/analysis/frontier.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace strandyn::analysis {

std::vector<bool> frontier(std::span<const Trade> trades) {
  // By rising cost: a setting is beaten if one that is cheaper is as near, or one that costs the same is nearer.
  std::vector<std::size_t> order(trades.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return trades[a].cost != trades[b].cost ? trades[a].cost < trades[b].cost : trades[a].error < trades[b].error;
  });
  std::vector<bool> best(trades.size(), false);
  double nearest = std::numeric_limits<double>::infinity();
  double cost = 0;
  for (const std::size_t i : order) {
    const bool twin = trades[i].cost == cost && trades[i].error == nearest;
    if (!(trades[i].error < nearest) && !twin) continue;
    best[i] = true;
    nearest = trades[i].error;
    cost = trades[i].cost;
  }
  return best;
}

std::optional<std::size_t> cheapest(std::span<const Trade> trades, double target, double unsure) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < trades.size(); ++i) {
    if (trades[i].error + unsure > target) continue;
    if (!best || trades[i].cost < trades[*best].cost) best = i;
  }
  return best;
}

}  // namespace strandyn::analysis
