#include "strandyn/math/low_pass.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::math {

namespace {

using std::numbers::pi;

struct Kernel {
  explicit Kernel(double cut_off) : f(0.85 * cut_off), half_width(9.2 / cut_off) {}

  double at(double s) const {
    const double x = s / half_width;
    if (std::abs(x) >= 1) return 0;
    const double window = 0.42 + 0.5 * std::cos(pi * x) + 0.08 * std::cos(2 * pi * x);
    const double angle = 2 * pi * f * s;
    return 2 * f * window * (angle == 0 ? 1 : std::sin(angle) / angle);
  }

  double f, half_width;
};

/// Sums kernel and curve times kernel over [from, to], where the curve is the straight line offset + slope s.
struct Sums {
  double kernel = 0, curve = 0;

  void add(const Kernel& h, double t, double from, double to, double offset, double slope) {
    from = std::max(from, t - h.half_width), to = std::min(to, t + h.half_width);
    if (to <= from) return;
    const double longest = 0.05 / h.f;
    const auto pieces = static_cast<int>(std::ceil((to - from) / longest));
    const double piece = (to - from) / pieces;
    for (int i = 0; i < pieces; ++i) {
      for (const double side : {-0.5, 0.5}) {
        const double s = from + piece * (i + 0.5 + side / std::sqrt(3.0));
        const double weight = piece / 2 * h.at(t - s);
        kernel += weight;
        curve += weight * (offset + slope * s);
      }
    }
  }
};

}  // namespace

Tabulated low_pass(const Tabulated& samples, double cut_off) {
  const std::vector<double>&time = samples.time, &value = samples.value;
  const Kernel h(cut_off);
  const auto steps = static_cast<std::size_t>(std::ceil((time.back() - time.front()) * 8 * cut_off));
  Tabulated result;
  for (std::size_t k = 0; k <= steps; ++k) {
    const double t = std::min(time.back(), time.front() + static_cast<double>(k) / (8 * cut_off));
    Sums sums;
    sums.add(h, t, t - h.half_width, time.front(), value.front(), 0);
    sums.add(h, t, time.back(), t + h.half_width, value.back(), 0);
    auto i = static_cast<std::size_t>(std::ranges::upper_bound(time, t - h.half_width) - time.begin());
    for (i = std::max<std::size_t>(i, 1); i < time.size() && time[i - 1] < t + h.half_width; ++i) {
      const double slope = (value[i] - value[i - 1]) / (time[i] - time[i - 1]);
      sums.add(h, t, time[i - 1], time[i], value[i - 1] - slope * time[i - 1], slope);
    }
    result.time.push_back(t);
    result.value.push_back(sums.curve / sums.kernel);
  }
  return result;
}

}  // namespace strandyn::math
