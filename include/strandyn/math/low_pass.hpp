#pragma once
/// \file Samples of a measurement without what is too fast for the steps that follow them.
///
///     y(t) = integral of h(t - s) x(s) ds,    h(s) = 2 f sinc(2 f s) w(s/W),    f = 0.85 f_c,    W = 9.2/f_c
/// x goes straight from sample to sample, whatever their steps, and holds its ends; w is Blackman's window [Oppenheim &
/// Schafer, Discrete-Time Signal Processing, 7.2]: below 0.7 f_c the gain is 1 within 3e-4, above f_c it is below 3e-4,
/// and nothing is delayed. A constant stays what it is, a straight line as far as W from the ends.

#include "strandyn/math/time_function.hpp"

namespace strandyn::math {

/// The same curve below `cut_off` [Hz] > 0, sampled evenly eight times in 1/cut_off.
Tabulated low_pass(const Tabulated& samples, double cut_off);

}  // namespace strandyn::math
