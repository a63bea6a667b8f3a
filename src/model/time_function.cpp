#include "strandyn/model/time_function.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::model {
namespace {

double evaluate(const Constant&, double) {
  return 1;
}

double evaluate(const Harmonic& h, double t) {
  return std::sin(2 * std::numbers::pi * h.frequency * t + h.phase);
}

double evaluate(const Tabulated& table, double t) {
  if (t <= table.time.front()) return table.value.front();
  if (t >= table.time.back()) return table.value.back();
  const auto next =
      static_cast<std::size_t>(std::upper_bound(table.time.begin(), table.time.end(), t) - table.time.begin());
  const double part = (t - table.time[next - 1]) / (table.time[next] - table.time[next - 1]);
  return table.value[next - 1] + part * (table.value[next] - table.value[next - 1]);
}

double rate(const Constant&, double) {
  return 0;
}

double rate(const Harmonic& h, double t) {
  const double omega = 2 * std::numbers::pi * h.frequency;
  return omega * std::cos(omega * t + h.phase);
}

double rate(const Tabulated& table, double t) {
  if (t < table.time.front() || t >= table.time.back()) return 0;
  const auto next =
      static_cast<std::size_t>(std::upper_bound(table.time.begin(), table.time.end(), t) - table.time.begin());
  return (table.value[next] - table.value[next - 1]) / (table.time[next] - table.time[next - 1]);
}

}  // namespace

double evaluate(const TimeFunction& function, double t) {
  return std::visit([t](const auto& f) { return evaluate(f, t); }, function);
}

double rate(const TimeFunction& function, double t) {
  return std::visit([t](const auto& f) { return rate(f, t); }, function);
}

}  // namespace strandyn::model
