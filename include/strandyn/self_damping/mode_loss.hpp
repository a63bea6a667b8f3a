#pragma once
/// \file The loss of a vibrating span per cycle and length: the sectional loss summed over a mode, no time integrated.
///
/// sine: the free span as a taut string, chi(x) = chi_a sin(k x), chi_a = m omega^2 A/T, whatever EI is:
///     mean D = (2/pi) integral of D(chi_a sin phi) dphi, phi from the onset of slip to pi/2
/// so P/f depends on m f^2 A/T alone at a given tension, whatever the law. Gauss-Legendre, places fixed by chi_a.
///
/// clamped: the exact mode of the tensioned beam between clamps with EI_max, boundary layers included. Bending makes
/// the wave longer: its curvature in the free span is lower than the string's by the share EI_max k^2/T. Near a clamp
/// wires slip and EI is lower than EI_max; the curvature there is then higher than this mode says, so the end loops
/// are an estimate. The free span leaves them out: it reaches from the first point of zero curvature beyond the
/// boundary layer to the last one.

#include <optional>

#include "strandyn/exact/tensioned_beam.hpp"
#include "strandyn/self_damping/sectional_loss.hpp"

namespace strandyn::self_damping {

/// [J/m] mean of a sine whose curvature amplitude at the antinode is `amplitude` [1/m].
double mean_loss_of_sine(const SectionalLoss& loss, double amplitude);

/// A mode of a clamped tensioned beam that vibrates at a given frequency.
struct ClampedMode {
  exact::TensionedBeam beam;  ///< its length is the one at which the mode has the frequency
  int number = 1;
};
/// The mode whose length at `frequency` [Hz] is nearest to that of `beam`, with that length: a laboratory, too, moves
/// the frequency of its span to where the test is.
ClampedMode clamped_mode_at(const exact::TensionedBeam& beam, double frequency);

/// Curvature of the free span, and the largest one, at the clamp, of an antinode amplitude of 1. [1/m^2]
struct ClampedCurvature {
  double free_span = 0, largest = 0;
};
ClampedCurvature curvature_of(const ClampedMode& mode);

struct SpanLoss {
  double mean = 0;                    ///< [J/m] over the whole span
  std::optional<double> free_span{};  ///< [J/m] without the end loops; nothing below three loops
};
SpanLoss loss_of_mode(const SectionalLoss& loss, const ClampedMode& mode, double antinode_amplitude);

}  // namespace strandyn::self_damping
