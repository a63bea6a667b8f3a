#pragma once
/// \file The battery: what every section law must satisfy, in one call. A law's own test only describes the law.
///
///     TEST_CASE("battery: the planar return map") {
///       check_law(PlanarReturnMap(curlew(), 36), {.curvature = 0.1, .strain = 5e-4});
///     }
///
/// The paths are random with a fixed seed; the environment variable STRANDYN_SEED sets another one. A failure tells the
/// seed, the point and the step.

#include "strandyn/section/law.hpp"

namespace strandyn::test {

/// What the battery must know about a law. The random paths wander within these ranges.
struct LawDescription {
  bool linear = false;    ///< no history and no loss; otherwise the paths must lose energy
  double curvature = 0;   ///< [1/m] well beyond the first slip, so that the paths slip and stick
  double strain = 0;      ///< [-] axial strain in the middle of its range, -0.3 to 2 times this
  double torsion = 0;     ///< [rad/m] spatial laws only
  double grid_angle = 0;  ///< [rad] spatial laws: turning the curvature by this turns the moment. 0: not isotropic
  int settling = 1;       ///< cycles of a closed loop after which it repeats; 1 where points obey Masing's rule
};

/// Runs all checks below.
void check_law(const section::Law& law, const LawDescription& what);

/// Rest is at rest: no strain, no resultants, no energy. Straight under tension: no moment.
void check_zero_at_zero(const section::Law& law, const LawDescription& what);
/// The tangent is the difference quotient, to 1e-6, at trial states of random committed histories.
void check_tangent(const section::Law& law, const LawDescription& what);
/// D >= 0 and E_quad >= 0 in every step of 1000 random paths with moving tension; and stored change + D - E_quad is
/// the trapezoidal work of the resultants. With the axial strain held the axial energy cancels and hides nothing.
void check_energies(const section::Law& law, const LawDescription& what);
/// respond writes no history, trial evaluations leave no trace, equal input gives equal bytes, and a state that is
/// accepted answers as it did on trial; accepted again, it loses nothing.
void check_purity(const section::Law& law, const LawDescription& what);
/// A point answers the same, to the bit, alone and among whatever neighbours; and the same, to rounding, with and
/// without the tangent.
void check_neighbours(const section::Law& law, const LawDescription& what);
/// At constant tension a closed loop of curvature repeats once it has settled.
void check_closed_loop(const section::Law& law, const LawDescription& what);
/// Turning the whole path of curvature turns the moment and leaves the energies.
void check_rotation(const section::Law& law, const LawDescription& what);

}  // namespace strandyn::test
