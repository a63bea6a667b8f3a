#pragma once
/// \file Time integration with the generalized-alpha method: one step, second order, numerical damping as chosen.
///
///     u1 = u0 + h v0 + h^2 ((1/2 - beta) a0 + beta a1),      v1 = v0 + h ((1 - gamma) a0 + gamma a1)
///     (1 - alpha_m) a1 + alpha_m a0 = (1 - alpha_f) w1 + alpha_f w0
///     M w1 + g + c v1 + f_int(u1; committed history) = f_ext                     all at the end of the step
/// w is the acceleration that goes with the forces, a an auxiliary one, of second order at a time beside. In a linear
/// chain this is the method of [CH1993], forces averaged by the trapezoidal form. Written so [AB2007], the equations
/// hold at the end of every step, those of unknowns without mass too; the law is asked there only; and order 2 needs no
/// constant mass matrix.
///
/// rho_inf is the factor per step on motions much faster than the step: 1 keeps them (a = w, the trapezoidal rule: no
/// damping at all), 0 removes them. What it does to a mode of omega, with k = (1 - rho_inf)/(1 + rho_inf):
///     zeta = k^3 (omega h)^3/2,      df/f = -(1/12 + 3 k^2/8) (omega h)^2        and O(h^4)
///
/// Steps may be fitted to one frequency [the prewarping of the bilinear transform, T1947]: with h stretched to s h in
/// all of the formulas above, while time goes on by h, a mode of that frequency keeps it, and the ratio of its
/// velocities to its displacements. With z = e^(i phi), phi = omega h, the formulas give w = -(x/h)^2 u,
///     x^2 = -[((1-alpha_m) z + alpha_m)/((1-alpha_f) z + alpha_f)] / [(1-gamma+gamma z)/(z-1)^2 + (1/2-beta+beta
///     z)/(z-1)]
/// whose real part is to be (s phi)^2; for the trapezoidal rule s phi = 2 tan(phi/2). The energies of a step close as
/// before: work is forces times displacements, and du = s h times the mean velocity.
///
/// A step that does not converge is halved, and halved again; its parts add up to the whole, so the ends of the cycles
/// are met as before.

namespace strandyn::solver {

struct GeneralizedAlpha {
  static constexpr const char* name = "generalized-alpha";
  /// Slip begins and ends within a cycle, at curvatures near the largest: with so many steps a cycle the friction is
  /// right to half a percent. More would cost and show nothing new.
  static constexpr int least_steps = 200;

  double rho_inf = 0.9;  ///< [-] 0 to 1

  double alpha_m() const { return (2 * rho_inf - 1) / (1 + rho_inf); }
  double alpha_f() const { return rho_inf / (1 + rho_inf); }
  double gamma() const { return 0.5 + alpha_f() - alpha_m(); }
  double beta() const { return (0.5 + gamma()) * (0.5 + gamma()) / 4; }

  /// s for a mode of angle omega h [rad] per step, below pi; 1 where the step does not resolve it.
  double stretch(double angle) const;

  /// Leading terms, without a stretch, for a mode of angle omega h [rad] per step.
  double damping_ratio(double angle) const;
  double frequency_error(double angle) const;  ///< relative
};

}  // namespace strandyn::solver
