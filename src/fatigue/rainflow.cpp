#include "strandyn/fatigue/rainflow.hpp"

#include <cmath>

namespace strandyn::fatigue {
namespace {

/// Peaks and valleys, both ends among them.
std::vector<double> reversals(std::span<const double> history) {
  std::vector<double> points;
  for (const double x : history) {
    if (!points.empty() && x == points.back()) continue;
    const std::size_t n = points.size();
    const bool goes_on = n >= 2 && (points[n - 1] > points[n - 2]) == (x > points[n - 1]);
    if (goes_on) points.pop_back();
    points.push_back(x);
  }
  return points;
}

CountedCycle cycle_of(double a, double b, double count) {
  return {.range = std::abs(a - b), .mean = (a + b) / 2, .count = count};
}

}  // namespace

std::vector<CountedCycle> rainflow(std::span<const double> history) {
  std::vector<CountedCycle> cycles;
  std::vector<double> open;
  std::size_t first = 0;  // in `open`: what has been counted before is gone
  for (const double point : reversals(history)) {
    open.push_back(point);
    while (open.size() - first >= 3) {
      const std::size_t n = open.size();
      const double X = std::abs(open[n - 1] - open[n - 2]);
      const double Y = std::abs(open[n - 2] - open[n - 3]);
      if (X < Y) break;
      if (n - 3 == first) {
        cycles.push_back(cycle_of(open[first], open[first + 1], 0.5));
        ++first;
      } else {
        cycles.push_back(cycle_of(open[n - 3], open[n - 2], 1));
        open.erase(open.end() - 3, open.end() - 1);
      }
    }
  }
  for (std::size_t i = first; i + 1 < open.size(); ++i) cycles.push_back(cycle_of(open[i], open[i + 1], 0.5));
  return cycles;
}

}  // namespace strandyn::fatigue
