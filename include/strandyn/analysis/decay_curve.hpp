#pragma once
/// \file Damping against amplitude, from the cycles of one free decay.
///
///     delta_i = ln(Y_(i-1)/Y_(i+1))/2       by the amplitudes of the neighbours; at either end by the one there is
///     P_i/L   = D_i f/L                     by the ledger, and from it zeta and loss factor          [IEEE563]
/// Two ways: delta/pi is a loss factor, too. It contains what the integrator takes, swings where other modes beat with
/// the decaying one, and misses that m L V^2/4 is the energy of a sine only.

#include <optional>
#include <vector>

#include "strandyn/analysis/steady.hpp"

namespace strandyn::analysis {

struct DecayingCycle {
  double number = 0;     ///< of the cycle; some may be left out
  double amplitude = 0;  ///< [m] of the antinode
  double lost = 0;       ///< [J] what counts as self-damping
};

/// At the amplitude of one cycle.
struct DampingAtAmplitude {
  double number = 0;
  double amplitude = 0;      ///< [m]
  double log_decrement = 0;  ///< [-] per cycle
  double damping_ratio = 0;  ///< [-] by the ledger
  double loss_factor = 0;    ///< [-] by the ledger
  double power = 0;          ///< [W/m] by the ledger
};

/// One entry per cycle. A cycle at rest has no decrement: it and all after it are left out.
std::vector<DampingAtAmplitude> damping_against_amplitude(const std::vector<DecayingCycle>& cycles,
                                                          const SpanNumbers& span);

/// l of P ~ Y^l, by least squares over the logarithms. Nothing where fewer than three cycles lose anything, or where
/// the amplitude stays within a tenth.
std::optional<double> exponent_of_amplitude(const std::vector<DampingAtAmplitude>& curve);

}  // namespace strandyn::analysis
