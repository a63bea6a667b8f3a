#pragma once
/// \file One section point of a law, driven by hand along a path of strain, with its account of energy.

#include <vector>

#include "strandyn/extremes/extreme.hpp"
#include "strandyn/section/law.hpp"

namespace strandyn::extremes {

/// Generalized strains; a planar law takes eps and chi2.
struct Strain {
  double eps = 0;   ///< [-]
  double chi2 = 0;  ///< [1/m]
  double chi3 = 0;  ///< [1/m]
  double chi1 = 0;  ///< [rad/m]
};
using Path = std::vector<Strain>;

/// What a state that was accepted answered, and the energies of the step. Moments in N m, energies in J/m.
struct Answer {
  double N = 0, M1 = 0, M2 = 0, M3 = 0;
  double EI = 0;  ///< [N m^2] dM2/dchi2
  double stored = 0, dissipated = 0, quadrature_error = 0;
};

class Point {
 public:
  Point(const section::Law& law, Strain start);
  Answer respond(Strain to);  ///< a trial: resultants and tangent
  Answer commit(Strain to);   ///< a trial and its acceptance

 private:
  void put(Strain to);

  const section::Law& law_;
  section::Field strains_, stresses_;
  section::TangentField tangents_;
  section::StepEnergy energy_;
  section::History history_;
};

/// The account of a path.
struct Walk {
  double lost = 0;         ///< [J/m] friction, all steps
  double least_loss = 0;   ///< [J/m] the smallest of a step: never below zero
  double least_error = 0;  ///< [J/m] the smallest E_quad of a step: the same
  /// [-] worst |stored change + D - E_quad - trapezoidal work| of a step over all that moved in it. The stored energy
  /// is a sum over layers and angles, known to some 32 units in the last place of the largest that the point remembers;
  /// that is allowed on top.
  double imbalance = 0;
  double work = 0, quadrature_error = 0;  ///< [J/m] all steps
  Answer end;
};
/// From its first strain, at which the law starts, along the others.
Walk walk(const section::Law& law, const Path& path);

/// `cycles` of a curvature (chi2 = amplitude sin) at a strain, `steps` each, after the start at rest.
Path cycles(double eps, double amplitude, int steps, int cycles = 1);

/// CPU seconds of a step along `path`, against a step of `ordinary_law` along ordinary cycles (Curlew at 15 % of its
/// strength, 0.03 1/m).
Cost cost_of(const section::Law& law, const Path& path, const section::Law& ordinary_law);

/// The three of a walk that hold for every law and every path.
void add_account(const Walk& w, Found& found);

}  // namespace strandyn::extremes
