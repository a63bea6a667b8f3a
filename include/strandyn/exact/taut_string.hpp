#pragma once
/// \file The taut string, and what a little sag does to it.
///
///     c = sqrt(T/m),   f_n = n c/(2 L)
///
/// A shallow cable under its weight w, of horizontal tension H:                                        [Irvine1981]
///     lambda^2 = (w L/H)^2 L EA/(H L_e),   L_e = L (1 + (w L/H)^2/8)
/// Its antisymmetric in-plane frequencies are the string's. The first symmetric one, over f_1 of the string, is 2 v/pi,
/// v in [pi/2, 3 pi/2) the root of tan v = v - 4 v^3/lambda^2.
/// Limits: lambda^2 = 0 gives 1; 4 pi^2 gives 2 (the crossover with mode 2); infinity gives tan v = v, 2.860593.

namespace strandyn::exact {

struct TautString {
  double tension = 0;          ///< [N]
  double mass_per_length = 0;  ///< [kg/m]
  double length = 0;           ///< [m]
};

/// [m/s] of transverse waves.
double wave_speed(const TautString& string);

/// [Hz] of mode n = 1, 2, ...
double frequency(const TautString& string, int n);

/// A level span, shallow: w L/H is small.
struct SaggedCable {
  double horizontal_tension = 0;  ///< [N]
  double weight_per_length = 0;   ///< [N/m]
  double EA = 0;                  ///< [N]
  double length = 0;              ///< [m] of the span
};

/// [-] lambda^2, the ratio of geometric to elastic stiffness.
double irvine_parameter(const SaggedCable& cable);

/// [-] first symmetric in-plane frequency over that of the taut string; `lambda_squared` >= 0, infinity allowed.
double first_symmetric_ratio(double lambda_squared);

}  // namespace strandyn::exact
