#include "strandyn/model/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace strandyn::model {
namespace {

/// How many elements lie between a graded end and the distance s from it: the integral of 1/size.
double count_from_end(double s, double end_size, double growth, double middle) {
  if (end_size >= middle) return s / middle;
  const double graded = (middle - end_size) / growth;  // where the size reaches the middle's
  if (s <= graded) return std::log1p(growth * s / end_size) / growth;
  return std::log(middle / end_size) / growth + (s - graded) / middle;
}

/// The span cut into a left and a right half, each counted from its own end.
struct Counter {
  const MeshOptions& o;
  double scale;  // all wanted sizes times this
  double middle;

  double half(double s, bool graded) const {
    return graded ? count_from_end(s, o.end_size * scale, o.growth * scale, middle) : s / middle;
  }
  double total() const { return half(o.length / 2, o.grade_left) + half(o.length / 2, o.grade_right); }
  double at(double s) const {
    if (s <= o.length / 2) return half(s, o.grade_left);
    return total() - half(o.length - s, o.grade_right);
  }
};

/// x in [low, high] with f(x) = target, f monotone increasing.
template <class F>
double bisect(F&& f, double low, double high, double target) {
  for (int i = 0; i < 200; ++i) {
    const double x = 0.5 * (low + high);
    (f(x) < target ? low : high) = x;
  }
  return 0.5 * (low + high);
}

/// Moves the nearest node onto each station and stretches what lies between, so that sizes change gently.
void meet_stations(std::vector<double>& nodes, std::vector<double> stations) {
  std::sort(stations.begin(), stations.end());
  std::vector<double> from = {nodes.front()};
  std::vector<double> to = {nodes.front()};
  for (double station : stations) {
    double nearest = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
      const bool closer = std::isnan(nearest) || std::abs(nodes[i] - station) < std::abs(nearest - station);
      if (nodes[i] > from.back() && closer) nearest = nodes[i];
    }
    const double apart = same_place(nodes.back() - nodes.front());
    if (std::isnan(nearest) || station - to.back() <= apart || nodes.back() - station <= apart) continue;
    from.push_back(nearest);
    to.push_back(station);
  }
  from.push_back(nodes.back());
  to.push_back(nodes.back());
  std::size_t piece = 1;
  for (double& s : nodes) {
    while (piece + 1 < from.size() && s > from[piece]) ++piece;
    const double part = (s - from[piece - 1]) / (from[piece] - from[piece - 1]);
    s = to[piece - 1] + part * (to[piece] - to[piece - 1]);
  }
}

}  // namespace

std::size_t elements_for(const MeshOptions& options, double middle) {
  constexpr double countable = 1e9;
  const double count = std::ceil(Counter{options, 1, middle}.total());
  return static_cast<std::size_t>(std::clamp(count, 1.0, countable));
}

std::vector<double> span_mesh(const MeshOptions& options) {
  const double n = static_cast<double>(options.elements);
  const double uniform = options.length / n;
  Counter counter{options, 1, uniform};
  const bool graded = (options.grade_left || options.grade_right) && options.end_size > 0 && options.end_size < uniform;
  if (graded) {
    // A longer middle needs fewer elements: find the one that gives n. If even a middle as long as the span is not
    // enough, the wanted sizes are too small for n elements: let them all grow.
    const auto with_middle = [&](double middle) { return -Counter{options, 1, middle}.total(); };
    if (-with_middle(options.length) <= n) {
      counter.middle = bisect(with_middle, options.end_size, options.length, -n);
    } else {
      const auto with_scale = [&](double scale) { return -Counter{options, scale, options.length}.total(); };
      counter.middle = options.length;
      counter.scale = bisect(with_scale, 1, 1e6, -n);
    }
  }
  std::vector<double> nodes(options.elements + 1);
  const double total = counter.total();
  for (std::size_t i = 0; i <= options.elements; ++i) {
    const double target = total * static_cast<double>(i) / n;
    nodes[i] = graded ? bisect([&](double s) { return counter.at(s); }, 0, options.length, target)
                      : uniform * static_cast<double>(i);
  }
  nodes.front() = 0;
  nodes.back() = options.length;
  meet_stations(nodes, options.stations);
  return nodes;
}

}  // namespace strandyn::model
