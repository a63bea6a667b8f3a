#pragma once
/// \file What the last cycles of a run say about the damping of the span, in the field's terms (IEEE Std 563).
///
///     P/L = D f/L,   V = omega Y,   zeta = 2 (P/L)/(m omega V^2),   loss factor = 2 zeta                [IEEE563]
/// with D the energy dissipated per cycle by friction, material and viscous damping, Y the antinode amplitude. Neither
/// still air nor the numerical part of the ledger is folded in: the share |numerical|/(D + air + dampers) stands
/// beside.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace strandyn::analysis {

/// Per cycle. [J], [m]
struct CycleLosses {
  double antinode_amplitude = 0;
  double friction = 0;
  double material = 0;
  double viscous = 0;
  double air = 0;
  double dampers = 0;  ///< hung on the span
  double numerical = 0;
};

struct SpanNumbers {
  double frequency = 0;        ///< [Hz]
  double length = 0;           ///< [m]
  double mass_per_length = 0;  ///< [kg/m]
};

/// zeta of a power per length [W/m] at an antinode amplitude [m]; 0 at rest.
double damping_ratio_at(double power, double antinode_amplitude, const SpanNumbers& span);

struct SteadyState {
  std::size_t cycles = 0;                 ///< over how many the means were taken
  double antinode_amplitude = 0;          ///< [m] mean
  double dissipation = 0;                 ///< [J] mean per cycle, friction, material and viscous
  double air = 0;                         ///< [J] mean per cycle
  double dampers = 0;                     ///< [J] likewise
  double self_damping = 0;                ///< [W/m]
  double damping_ratio = 0;               ///< [-] zeta
  double loss_factor = 0;                 ///< [-]
  std::optional<double> numerical_share;  ///< [-] nothing where nothing is dissipated
};

/// Over the last `last` cycles, or all if there are fewer.
SteadyState steady_state(const std::vector<CycleLosses>& cycles, const SpanNumbers& span, std::size_t last = 20);

/// What flows through a span in a cycle.
struct CycleFlow {
  double amplitude = 0;  ///< [m] of the antinode, or of the mode
  double in = 0;         ///< [J] work of the loads
  double lost = 0;       ///< [J] to physics and to the integrator
};
inline constexpr std::size_t cycles_that_show_steadiness = 20;
/// Like amplitudes (within 0.2 %), and what comes in is what is lost (within 0.5 %); `nothing` [J] a cycle is nothing.
bool is_steady(std::span<const CycleFlow> cycles, double nothing = 0);

/// How far cycles are from being steady in their mean. Other modes beat with the one that is shaken and die out slowly:
/// they swing single cycles to and fro, and leave a trend as it is. A drift is what the straight line through all
/// cycles moves from the first to the last, of their mean.
struct Steadiness {
  std::size_t cycles = 0;
  double amplitude_drift = 0;                 ///< [-]
  double loss_drift = 0;                      ///< [-]
  std::optional<double> work_in_over_lost{};  ///< [-] nothing where nothing is lost
};
Steadiness steadiness(std::span<const CycleFlow> cycles);
/// 20 cycles and more; what comes in is what is lost (within 0.5 %), and neither the loss (0.5 %) nor the amplitude
/// (0.3 %) goes up or down.
bool is_steady(const Steadiness& steadiness);

}  // namespace strandyn::analysis
