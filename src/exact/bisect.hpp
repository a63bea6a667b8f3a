#pragma once
/// \file The one root finder of this module: bisection down to neighbouring doubles. Slow and beyond doubt.

namespace strandyn::exact {

/// An interval in which `function` falls from positive (at `positive`) to negative (at `negative`); either may be the
/// larger. The ends themselves are not evaluated.
struct SignChange {
  double positive = 0;
  double negative = 0;
};

template <class Function>
double bisect(SignChange interval, Function&& function) {
  while (true) {
    const double middle = interval.positive + (interval.negative - interval.positive) / 2;
    if (middle == interval.positive || middle == interval.negative) return middle;
    (function(middle) > 0 ? interval.positive : interval.negative) = middle;
  }
}

}  // namespace strandyn::exact
