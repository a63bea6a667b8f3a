#include "strandyn/math/time_function.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::math {

double Harmonic::at(double t) const {
  return std::sin(2 * std::numbers::pi * frequency * t + phase);
}

double Harmonic::rate(double t) const {
  const double omega = 2 * std::numbers::pi * frequency;
  return omega * std::cos(omega * t + phase);
}

double Tabulated::at(double t) const {
  if (t <= time.front()) return value.front();
  if (t >= time.back()) return value.back();
  const auto next = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
  const double part = (t - time[next - 1]) / (time[next] - time[next - 1]);
  return value[next - 1] + part * (value[next] - value[next - 1]);
}

double Tabulated::rate(double t) const {
  if (t < time.front() || t >= time.back()) return 0;
  const auto next = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
  return (value[next] - value[next - 1]) / (time[next] - time[next - 1]);
}

std::vector<double> Tabulated::corners() const {
  constexpr std::size_t most_rows = 50;
  return time.size() > most_rows ? std::vector<double>() : time;
}

double Driven::at(double t, std::span<const Drive> drives) const {
  if (drive >= drives.size()) return 0;
  const Drive& d = drives[drive];
  return d.amplitude * Harmonic{.frequency = d.frequency, .phase = d.phase}.at(t);
}

double Driven::rate(double t, std::span<const Drive> drives) const {
  if (drive >= drives.size()) return 0;
  const Drive& d = drives[drive];
  return d.amplitude * Harmonic{.frequency = d.frequency, .phase = d.phase}.rate(t);
}

double evaluate(const TimeFunction& function, double t, std::span<const Drive> drives) {
  return std::visit(
      [&](const auto& f) {
        if constexpr (requires { f.at(t, drives); }) {
          return f.at(t, drives);
        } else {
          return f.at(t);
        }
      },
      function);
}

double rate(const TimeFunction& function, double t, std::span<const Drive> drives) {
  return std::visit(
      [&](const auto& f) {
        if constexpr (requires { f.rate(t, drives); }) {
          return f.rate(t, drives);
        } else {
          return f.rate(t);
        }
      },
      function);
}

std::vector<double> corners(const TimeFunction& function) {
  return std::visit(
      [](const auto& f) {
        if constexpr (requires { f.corners(); }) {
          return f.corners();
        } else {
          return std::vector<double>();
        }
      },
      function);
}

}  // namespace strandyn::math
