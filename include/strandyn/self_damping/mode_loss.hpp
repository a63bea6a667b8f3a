#pragma once
/// \file The loss of a vibrating span per cycle and length: the sectional loss summed over a mode, no time integrated.
///
/// sine: the free span as a wave of the tensioned beam with the law's own secant stiffness at the antinode,
///     k^2 = (-T + sqrt(T^2 + 4 EI m omega^2))/(2 EI),   EI = M(k^2 A)/(k^2 A)
///     chi(x) = chi_a sin(k x), chi_a = k^2 A,   mean D = (2/pi) integral of D(chi_a sin phi) dphi
/// phi from the onset of slip to pi/2. Gauss-Legendre, places fixed by chi_a. EI rises with EI itself, by less: its
/// fixed point is reached from above.
///
/// string: the same with EI = 0, chi_a = m omega^2 A/T. Then P/f depends on m f^2 A/T alone at a given tension,
/// whatever the law, and local exponents obey m = 2 l + 1.
///
/// clamped: the exact mode of the tensioned beam between clamps with EI_max, boundary layers included. Bending makes
/// the wave longer: its curvature in the free span is lower than the string's by the share EI_max k^2/T. Near a clamp
/// wires slip and EI is lower than EI_max; the curvature there is then higher than this mode says, so the end loops
/// are an estimate. The free span leaves them out: it reaches from the first point of zero curvature beyond the
/// boundary layer to the last one.

#include <functional>
#include <optional>

#include "strandyn/exact/tensioned_beam.hpp"
#include "strandyn/self_damping/sectional_loss.hpp"

namespace strandyn::self_damping {

/// [J/m] mean of a sine whose curvature amplitude at the antinode is `amplitude` [1/m].
double mean_loss_of_sine(const SectionalLoss& loss, double amplitude);

/// The loop of a free span. [1/m], [1/m], [N m^2]
struct Loop {
  double wavenumber = 0, curvature = 0, EI = 0;
};
struct Wave {
  double tension = 0;             ///< [N]
  double mass_per_length = 0;     ///< [kg/m]
  double frequency = 0;           ///< [Hz]
  double antinode_amplitude = 0;  ///< [m]
};
Loop stiff_loop(const SectionalLoss& loss, const Wave& wave);
Loop string_loop(const Wave& wave);

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
/// The mean of any function of the curvature amplitude [1/m] and of the deflection amplitude [m] over the same lengths.
SpanLoss mean_over_mode(const ClampedMode& mode, double antinode_amplitude,
                        const std::function<double(double curvature, double deflection)>& f);

}  // namespace strandyn::self_damping
