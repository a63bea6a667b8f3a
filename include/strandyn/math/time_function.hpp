#pragma once
/// \file How a load or a motion changes with time.
///
/// Each form knows its own value and rate; a new one is a struct in a header of its own and a name in the list.

#include <span>
#include <variant>
#include <vector>

namespace strandyn::math {

/// What shakes, decided when the model is long built: amplitude sin(2 pi f t + phase).
struct Drive {
  double frequency = 0;  ///< [Hz]
  double amplitude = 1;  ///< [-] of the load or the motion that follows it
  double phase = 0;      ///< [rad]
};

/// 1 at all times.
struct Constant {
  double at(double) const { return 1; }
  double rate(double) const { return 0; }
};

/// sin(2 pi f t + phase): without a phase it starts from zero, so a force begins without a jump.
struct Harmonic {
  double frequency = 0;  ///< [Hz]
  double phase = 0;      ///< [rad]

  double at(double t) const;
  double rate(double t) const;
};

/// Straight lines between given points, or the smooth curve through them; constant before the first and after the last.
struct Tabulated {
  std::vector<double> time;        ///< [s] increasing
  std::vector<double> value;       ///< [-]
  std::vector<double> slope = {};  ///< [1/s] of the smooth curve at the points; empty: straight lines

  double at(double t) const;
  double rate(double t) const;  ///< at a corner that of the line which begins there
  /// [s] where the rate jumps. A table of many rows is a measured signal that the steps resolve: it has none.
  std::vector<double> corners() const;
  /// [1/s] the largest jump of the rate before a time [s], those at both ends included.
  double largest_jump(double before) const;
};

/// The cubic spline through the points of a table, its second derivative continuous and its third also beside the ends
/// ("not a knot"): samples of a smooth signal, to the fourth power of their distance. Fewer than four points: straight.
Tabulated smooth(Tabulated table);

/// Swells from 0 to 1 by a raised cosine: what begins at full velocity can be brought in without a jump.
struct Ease {
  double duration = 0;  ///< [s] 0: at once

  double at(double t) const;
  double rate(double t) const;  ///< [1/s]
};

/// As a drive of the run says; 0 in an analysis that has no such drive.
struct Driven {
  std::size_t drive = 0;  ///< its number

  double at(double t, std::span<const Drive> drives) const;
  double rate(double t, std::span<const Drive> drives) const;
};

using TimeFunction = std::variant<Constant, Harmonic, Tabulated, Driven>;

/// The factor at time t [s].
double evaluate(const TimeFunction& function, double t, std::span<const Drive> drives = {});

/// [1/s] its derivative.
double rate(const TimeFunction& function, double t, std::span<const Drive> drives = {});

/// [s] where a step of an integration must end.
std::vector<double> corners(const TimeFunction& function);

}  // namespace strandyn::math
