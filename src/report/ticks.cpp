#include "strandyn/report/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "strandyn/report/format.hpp"

namespace strandyn::report {
namespace {

/// Relative slack for a bound that is a multiple of the step but for rounding.
constexpr double slack = 1e-9;

std::string with_minus_sign(std::string text) {
  if (text.starts_with('-')) text.replace(0, 1, "−");
  return text;
}

/// One label: plain decimals where they are short, powers of ten where they are not.
std::string tick_label(double value, double step) {
  const int step_exponent = static_cast<int>(std::floor(std::log10(step) + slack));
  const int decimals = std::max(0, -step_exponent);
  if (value == 0) return "0";
  if (decimals > 5 || std::abs(value) >= 1e6) {
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value)) + slack));
    return typeset(value, std::clamp(exponent - step_exponent + 1, 1, 6));
  }
  return with_minus_sign(fmt::format("{:.{}f}", value, decimals));
}

/// 0.01, 20, 10⁻⁵, 2×10⁷.
std::string log_label(double value) {
  constexpr std::string_view one_times = "1×";
  const std::string text = typeset(value, 1);
  return text.starts_with(one_times) ? text.substr(one_times.size()) : text;
}

}  // namespace

double nice_step(Range range, int most) {
  const double raw = range.width() / std::max(most, 1);
  const double power = std::pow(10, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw * (1 - slack)) return factor * power;
  }
  return 10 * power;
}

Range widened_to_steps(Range range, int most) {
  const double step = nice_step(range, most);
  return {step * std::floor(range.low / step + slack), step * std::ceil(range.high / step - slack)};
}

Ticks linear_ticks(Range range, int most) {
  const double step = nice_step(range, most);
  const double first = std::ceil(range.low / step - slack);
  const double last = std::floor(range.high / step + slack);
  Ticks ticks;
  for (double k = first; k <= last; ++k) {
    const double value = k == 0 ? 0 : k * step;
    ticks.at.push_back(value);
    ticks.labels.push_back(tick_label(value, step));
  }
  return ticks;
}

Ticks log_ticks(Range range) {
  const double low = std::log10(range.low) - slack;
  const double high = std::log10(range.high) + slack;
  constexpr double most_labels = 8;
  const double decades = std::floor(high) - std::ceil(low);
  const bool few = decades < 2;
  const double stride = std::max(1.0, std::ceil(decades / most_labels));
  Ticks ticks;
  for (double decade = std::floor(low); decade <= high; ++decade) {
    if (std::fmod(decade, stride) != 0) continue;
    for (int factor = 1; factor < (stride > 1 ? 2 : 10); ++factor) {
      const double value = factor * std::pow(10, decade);
      if (std::log10(value) < low || std::log10(value) > high) continue;
      const bool labelled = factor == 1 || (few && (factor == 2 || factor == 5));
      ticks.at.push_back(value);
      ticks.labels.push_back(labelled ? log_label(value) : "");
    }
  }
  return ticks;
}

}  // namespace strandyn::report
