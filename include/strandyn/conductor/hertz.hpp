#pragma once
/// \file How far contacting wires give under friction: Hertz spots where wires cross, Hertz lines where they lie along.
///
/// Spot (Cattaneo-Mindlin). Two wires of radii r1, r2 cross under the angle phi and press with P: an ellipse of half
/// axes a > b, at 12 to 26 degrees 5 to 12 times as long as wide, its long axis between the wires, where they slip.
/// With 1/E* = sum (1 - nu^2)/E, G = E/(2 (1 + nu)), k = b/a, e^2 = 1 - k^2, complete elliptic integrals K(e), E(e), D
/// = (K - E)/e^2,
///     A + B = (1/r1 + 1/r2)/2,   (B - A)^2 = [1/r1^2 + 1/r2^2 + 2 cos(2 phi)/(r1 r2)]/4
///     B/A = (K - D)/(k^2 D),     a^3 = 3 P D/(2 pi E* A)                               [Johnson 1985, 4.2]
///     dQ/du = 2 pi a/sum[((1 - nu) K + nu D)/G]              along the long axis [Mindlin 1949; Johnson 1985, 7.2]
///     u_star = 3 mu P/(2 dQ/du),    Q = mu P [1 - (1 - u/u_star)^(3/2)]
/// A circle, phi = 90 degrees and r1 = r2, has 8 a/sum[(2 - nu)/G].
///
/// Line. The wires of layer 1 lie along the core, and slip along the line. Per unit length the wire is in antiplane
/// shear: traction t on a strip of half width b, balanced by the gradient of the axial force over the section. The
/// Neumann function of the disc, -ln|x - x0|/pi + |x|^2/(4 pi r^2), gives the strip's displacement against the mean of
/// the section in closed form, and the Hertzian traction gives Cattaneo's partial slip, y = 1 - t/(mu p):
///     stuck    u = t sum (1/(pi G)) [ln(2 r/b) + 1/8],       b^2 = 4 p R'/(pi E*),  1/R' = 1/r1 + 1/r2
///     sliding  u = mu p sum (1/(pi G)) [(1 - y) Lambda + y ln(y)/2],   Lambda = ln(2 r/b) + 5/8
/// (Lambda weighted by 1/G over the two bodies). The core feels six such lines and not one; that changes its half by a
/// number of order one beside a logarithm of six, and is left out.
///
/// Wires count as round with the radius d/2, trapezoidal ones, too, and as straight at the scale of a contact.

#include <vector>

#include "strandyn/conductor/strand.hpp"

namespace strandyn::conductor {

struct ContactBody {
  double radius = 0;   ///< [m] of the wire's surface
  double young = 0;    ///< [Pa]
  double poisson = 0;  ///< [-]

  double shear() const { return young / (2 * (1 + poisson)); }  ///< [Pa]
};
struct BodyPair {
  ContactBody first, second;
};

/// A tangential stiffness and how it grows with the force that presses.
struct Stiffness {
  double value = 0;  ///< [N/m] of a spot, [N/m^2] of a line
  double slope = 0;  ///< d value/d(pressing force); 0 where nothing presses
};

class SpotContact {
 public:
  SpotContact() = default;
  SpotContact(const BodyPair& bodies, double crossing_angle);

  double long_half_axis(double force) const;  ///< [m] a under `force` [N]
  double axis_ratio() const { return k_; }    ///< [-] b/a, the same under every force
  Stiffness stiffness(double force) const;    ///< along the long axis

 private:
  double k_ = 1;
  double axis_per_cube_root_ = 0;  ///< [m/N^(1/3)]
  double compliance_ = 0;          ///< [1/Pa] stiffness = 2 pi a/this
};

class LineContact {
 public:
  LineContact() = default;
  explicit LineContact(const BodyPair& bodies);

  double half_width(double load) const;      ///< [m] under `load` [N/m]; no more than the smaller radius
  Stiffness stiffness(double load) const;    ///< while all of the strip sticks
  double slip_logarithm(double load) const;  ///< Lambda [-]

 private:
  BodyPair bodies_;
  double width_per_root_ = 0;  ///< [m/(N/m)^(1/2)]
};

/// Where the wires of a layer meet those of the layer inside.
struct Interface {
  bool line = false;          ///< along a line; otherwise in spots
  double crossing_angle = 0;  ///< [rad] between the wires at the radius where they meet
  double per_outer_wire = 1;  ///< spots per length of a wire of the outer layer [1/m]; of lines: their number [-]
  double per_inner_wire = 0;  ///< the same for a wire of the inner layer; 0 for the core, which carries no gradient
  SpotContact spot;
  LineContact along;

  /// Stiffness per length of a wire [N/m^2] that has `share` contacts (one of the two above) and is pressed by `load`
  /// [N/m].
  Stiffness stiffness(double load, double share) const;
};

/// One entry per layer, core first: its contact with the layer inside (the core's own entry is empty). In terms of the
/// angles per length w = tan(alpha)/R, wires of two layers cross n_outer n_inner |w_outer - w_inner|/(2 pi) times per
/// length of strand. A layer on the core, and one that crosses not even one wire in a turn, touches along a line.
std::vector<Interface> interfaces(const Strand& strand);

}  // namespace strandyn::conductor
