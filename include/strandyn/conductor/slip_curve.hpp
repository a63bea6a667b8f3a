#pragma once
/// \file How a contact gives way under a growing slip u: its traction over its friction limit, x = u/u_star in [0, 1],
///     spot (Cattaneo, Mindlin)   g = 1 - (1 - x)^(3/2)
///     line                       g + (1 - g) ln(1 - g)/(2 Lambda) = x
/// and the parallel chain of elastic-plastic springs that stands for it [Iwan 1966], with the density -g'' of reaches.

#include <vector>

namespace strandyn::conductor {

/// The springs of one contact, from the smallest limit to the largest.
struct SpringChain {
  std::vector<double> stiffness;  ///< [-] kappa_i, parts of the contact's first stiffness
  std::vector<double> limit;      ///< [-] phi_i, parts of its friction limit: multiples of 2^-52, whose sums are exact
};

/// Traction over its limit, and its slope, against x = u/u_star in [0, 1]: the virgin curve of a contact.
class SlipCurve {
 public:
  static SlipCurve spot();                  ///< 1 - (1 - x)^(3/2)
  static SlipCurve line(double logarithm);  ///< x = (1 - y) + y ln(y)/(2 Lambda), traction 1 - y
  double traction(double x) const;          ///< g
  double slope(double x) const;             ///< g'
  double loss_moment(double x) const;       ///< g - x g': the limits of all that slips at x
 private:
  double logarithm_ = 0;  ///< 0: a spot
};

struct ChainPlan {
  int springs = 17;
  double smallest_slip = 3e-5;
  double phase = 0;  ///< [0, 1) shift of the grading by this part of its ratio
};
/// r: the limits of neighbouring springs differ by this factor.
double grading_ratio(const ChainPlan& plan);
/// Keeps, exactly, the curve's first stiffness and limit, and on the average over phases the loss at small amplitudes.
SpringChain spring_chain(const SlipCurve& curve, const ChainPlan& plan);

}  // namespace strandyn::conductor
