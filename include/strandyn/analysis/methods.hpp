#pragma once
/// \file The measures of self-damping of a laboratory span, and how they turn into each other.  [IEEE563] [IEC62567]
///
///     power    P = F V_F cos(phi)/2 = (work of a cycle) f,   over the length L
///     decay    delta = ln(Y_0/Y_N)/N,   P/L = m f delta V^2/2
///     ISWR     S = a/Y,   P = S Z V^2/2 through a node,   P/L = Z V^2 (S_n - S_k)/(2 N lambda/2) between two of them
///     zeta     = 2 (P/L)/(m omega V^2),   loss factor = 2 zeta
/// All amplitudes are half of peak to peak and not rms: Y of an antinode, a of a node, F and V_F at the shaker;
/// V = omega Y. A sine of amplitude Y along x carries m V^2/4 per length, and delta loses the share 2 delta of it per
/// cycle: that is where the decay formula comes from, so it holds to the order of delta.
///
/// Z is the power that a running wave of unit velocity amplitude carries, times two:
///     m omega^2 = T k^2 + EI k^4,   Z = (T k + 2 EI k^3)/omega
/// With EI = 0 it is sqrt(T m), the form of the standards. Bending adds the share 3/2 EI k^2/T: 10 % for an ACSR of
/// 27 mm at 20 Hz and 20 % of its strength with all wires sticking.

#include <complex>
#include <cstddef>
#include <optional>
#include <span>

namespace strandyn::analysis {

/// A span in sine vibration, as the conversions below need it.
struct Antinode {
  double mass_per_length = 0;  ///< [kg/m]
  double frequency = 0;        ///< [Hz]
  double velocity = 0;         ///< [m/s] V = omega Y
};

double damping_ratio(double power_per_length, const Antinode& antinode);  ///< zeta [-]
double power_per_length(double damping_ratio, const Antinode& antinode);  ///< [W/m]
double loss_factor(double damping_ratio);                                 ///< 2 zeta [-]

/// What the shaker does in steady state.
struct Drive {
  double force = 0;     ///< [N]
  double velocity = 0;  ///< [m/s] V_F of the driven point
  double phase = 0;     ///< [rad] between the two
};
struct CycleWork {
  double work = 0;       ///< [J] done on the span in one cycle
  double frequency = 0;  ///< [Hz]
};

double drive_power(const Drive& drive);                                         ///< [W]
double drive_power(std::complex<double> force, std::complex<double> velocity);  ///< [W] both times exp(i omega t)
double power_method(const Drive& drive, double length);                         ///< [W/m]
double power_method(const CycleWork& cycle, double length);                     ///< [W/m]

struct Decay {
  double first_amplitude = 0;  ///< [m] Y_0
  double last_amplitude = 0;   ///< [m] Y_N
  double cycles = 0;           ///< [-] N, between the two
};
struct DecrementFit {
  double decrement = 0;                    ///< [-]
  double first_amplitude = 0;              ///< [m] of the fitted line at the first cycle
  std::optional<double> standard_error{};  ///< [-] of the decrement; nothing with two amplitudes only
};

double logarithmic_decrement(const Decay& decay);
/// Least squares of ln Y_i = ln Y_0 - delta i over amplitudes one cycle apart. Nothing for fewer than two, or where one
/// is not above zero. Where damping depends on the amplitude, fit stretches of few cycles.
std::optional<DecrementFit> fit_decrement(std::span<const double> amplitudes);
double decay_method(double decrement, const Antinode& antinode);  ///< [W/m] at the amplitude of `antinode`
/// zeta of a viscous oscillator with this decrement, delta/sqrt(4 pi^2 + delta^2); delta/(2 pi) where it is small.
double damping_ratio_of_decrement(double decrement);

/// What waves run on.
struct WaveGuide {
  double tension = 0;          ///< [N]
  double mass_per_length = 0;  ///< [kg/m]
  double EI = 0;               ///< [N m^2] 0 for the form of the standards
};

double wavenumber(const WaveGuide& guide, double frequency);      ///< [1/m] k of the running wave
double loop_length(const WaveGuide& guide, double frequency);     ///< [m] half a wavelength, pi/k
double wave_impedance(const WaveGuide& guide, double frequency);  ///< [kg/s] Z

/// What is read at a node and at the antinode beside it.
struct NodeReading {
  double node_amplitude = 0;      ///< [m] a, the smallest amplitude around the node
  double antinode_amplitude = 0;  ///< [m] Y
};
/// Two nodes, the near one closer to the shaker.
struct NodePair {
  NodeReading near, far;
  double distance = 0;  ///< [m] between them: N lambda/2
};

double inverse_standing_wave_ratio(const NodeReading& node);  ///< S [-]
/// Power that runs through a node to what lies beyond [W]. Exact for two opposite waves: amplitudes A + B at the
/// antinode, A - B at the node, Z omega^2 (A^2 - B^2)/2 between.
double power_at_node(const NodeReading& node, const WaveGuide& guide, double frequency);
/// Lost between the two nodes [W/m], each with the amplitude of its own antinode; with one amplitude it is the formula
/// above. No loss of the clamps and of the shaker enters.
double iswr_method(const NodePair& nodes, const WaveGuide& guide, double frequency);

}  // namespace strandyn::analysis
