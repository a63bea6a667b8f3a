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

namespace {

/// Between two points of a smooth table: cubic with the values and the slopes of both.
struct Piece {
  double length, part, low, high, low_slope, high_slope;

  double at() const {
    const double rest = 1 - part;
    return rest * rest * ((1 + 2 * part) * low + part * length * low_slope) +
           part * part * ((1 + 2 * rest) * high - rest * length * high_slope);
  }
  double rate() const {
    const double rest = 1 - part;
    return 6 * part * rest * (high - low) / length + rest * (1 - 3 * part) * low_slope +
           part * (1 - 3 * rest) * high_slope;
  }
};

Piece piece_of(const Tabulated& table, double t) {
  const auto next =
      static_cast<std::size_t>(std::upper_bound(table.time.begin(), table.time.end(), t) - table.time.begin());
  const double length = table.time[next] - table.time[next - 1];
  Piece piece{.length = length,
              .part = (t - table.time[next - 1]) / length,
              .low = table.value[next - 1],
              .high = table.value[next],
              .low_slope = 0,
              .high_slope = 0};
  if (!table.slope.empty()) piece.low_slope = table.slope[next - 1], piece.high_slope = table.slope[next];
  return piece;
}

}  // namespace

double Tabulated::at(double t) const {
  if (t <= time.front()) return value.front();
  if (t >= time.back()) return value.back();
  const Piece piece = piece_of(*this, t);
  return slope.empty() ? piece.low + piece.part * (piece.high - piece.low) : piece.at();
}

double Tabulated::rate(double t) const {
  if (t < time.front() || t >= time.back()) return 0;
  const Piece piece = piece_of(*this, t);
  return slope.empty() ? (piece.high - piece.low) / piece.length : piece.rate();
}

std::vector<double> Tabulated::corners() const {
  constexpr std::size_t most_rows = 50;
  if (!slope.empty()) return {time.front(), time.back()};
  return time.size() > most_rows ? std::vector<double>() : time;
}

double Tabulated::largest_jump(double before) const {
  const double nearly = before * (1 - 1e-9);  // what happens at the end does not happen
  if (!slope.empty()) {
    return std::max(time.front() < nearly ? std::abs(slope.front()) : 0,
                    time.back() < nearly ? std::abs(slope.back()) : 0);
  }
  double earlier = 0, largest = 0;
  for (const double t : time) {
    if (t >= nearly) break;
    const double later = rate(t);
    largest = std::max(largest, std::abs(later - earlier));
    earlier = later;
  }
  return largest;
}

Tabulated smooth(Tabulated table) {
  const std::size_t n = table.time.size();
  if (n < 4) return table;
  std::vector<double> h(n - 1), chord(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h[i] = table.time[i + 1] - table.time[i];
    chord[i] = (table.value[i + 1] - table.value[i]) / h[i];
  }
  // lower s_(i-1) + diagonal s_i + upper s_(i+1) = right; the end rows are "not a knot" with the third unknown taken
  // out by the row beside it. [de Boor 1978, ch. IV]
  std::vector<double> lower(n, 0.0), diagonal(n), upper(n, 0.0), right(n);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    lower[i] = h[i];
    diagonal[i] = 2 * (h[i - 1] + h[i]);
    upper[i] = h[i - 1];
    right[i] = 3 * (h[i] * chord[i - 1] + h[i - 1] * chord[i]);
  }
  const auto end_row = [](double near, double next, double near_chord, double next_chord) {
    const double both = near + next;
    return ((near + 2 * both) * next * near_chord + near * near * next_chord) / both;
  };
  diagonal[0] = h[1];
  upper[0] = h[0] + h[1];
  right[0] = end_row(h[0], h[1], chord[0], chord[1]);
  diagonal[n - 1] = h[n - 3];
  lower[n - 1] = h[n - 2] + h[n - 3];
  right[n - 1] = end_row(h[n - 2], h[n - 3], chord[n - 2], chord[n - 3]);
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = lower[i] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    right[i] -= factor * right[i - 1];
  }
  table.slope.resize(n);
  table.slope[n - 1] = right[n - 1] / diagonal[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) table.slope[i] = (right[i] - upper[i] * table.slope[i + 1]) / diagonal[i];
  return table;
}

double Ease::at(double t) const {
  if (duration <= 0 || t >= duration) return 1;  // also before 0, where a difference may look
  return t <= 0 ? 0 : 0.5 * (1 - std::cos(std::numbers::pi * t / duration));
}

double Ease::rate(double t) const {
  if (t <= 0 || t >= duration) return 0;
  const double turn = std::numbers::pi / duration;
  return 0.5 * turn * std::sin(turn * t);
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
