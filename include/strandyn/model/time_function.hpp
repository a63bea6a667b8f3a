#pragma once
/// \file How a load or a motion changes with time.

#include <variant>
#include <vector>

namespace strandyn::model {

/// 1 at all times.
struct Constant {};

/// sin(2 pi f t + phase): without a phase it starts from zero, so a force begins without a jump.
struct Harmonic {
  double frequency = 0;  ///< [Hz]
  double phase = 0;      ///< [rad]
};

/// Straight lines between given points; constant before the first and after the last.
struct Tabulated {
  std::vector<double> time;   ///< [s] increasing
  std::vector<double> value;  ///< [-]
};

using TimeFunction = std::variant<Constant, Harmonic, Tabulated>;

/// The factor at time t [s].
double evaluate(const TimeFunction& function, double t);

/// [1/s] its derivative; at a corner of a table that of the line which begins there.
double rate(const TimeFunction& function, double t);

}  // namespace strandyn::model
