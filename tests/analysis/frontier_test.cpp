#include "strandyn/analysis/frontier.hpp"

#include <doctest/doctest.h>

#include <random>
#include <vector>

using namespace strandyn::analysis;

TEST_CASE("frontier: a setting is on it unless another one is as cheap and as near, and better in one of the two") {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> few(0, 6);  // many alike
  for (int round = 0; round < 200; ++round) {
    std::vector<Trade> trades;
    for (int i = 0; i < 12; ++i) trades.push_back({.cost = 1.0 * few(random), .error = 0.5 * few(random)});
    const std::vector<bool> found = frontier(trades);
    for (std::size_t i = 0; i < trades.size(); ++i) {
      bool beaten = false;
      for (const Trade& other : trades) {
        const bool as_good = other.cost <= trades[i].cost && other.error <= trades[i].error;
        beaten = beaten || (as_good && (other.cost < trades[i].cost || other.error < trades[i].error));
      }
      CHECK(found[i] == !beaten);
    }
  }
}

TEST_CASE("frontier: the cheapest for a target leaves room for what is unsure of the reference") {
  const std::vector<Trade> trades{{.cost = 1, .error = 0.05}, {.cost = 4, .error = 0.015}, {.cost = 9, .error = 0.001}};
  CHECK(cheapest(trades, 0.1, 0) == 0);
  CHECK(cheapest(trades, 0.02, 0) == 1);
  CHECK(cheapest(trades, 0.02, 0.004) == 1);
  CHECK(cheapest(trades, 0.02, 0.006) == 2);
  CHECK_FALSE(cheapest(trades, 0.001, 0.006).has_value());
  CHECK_FALSE(cheapest({}, 1, 0).has_value());
}
