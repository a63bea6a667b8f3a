#pragma once
/// \file Free vibration of a uniform beam under tension, without rotary inertia and shear.
///
///     EI w'''' - T w'' + m w,tt = 0,   xi = L sqrt(T/EI),   p^2 - r^2 = xi^2,   omega = p r sqrt(EI/m)/L^2
///     [Bokaian1990] pinned:   r = n pi,   f_n/(n f_string) = sqrt(1 + (n pi/xi)^2) clamped:  2 p r (1 - cosh p cos r)
///     + xi^2 sinh p sin r = 0,   n pi < r < (n + 1) pi
///
/// solved to rounding, divided by cosh p so that nothing overflows. Range: T >= 0, EI > 0, any xi, n >= 1.
/// Limits: xi -> infinity gives n f_string (clamped: n f_string (1 + 2/xi + ...)); T = 0 gives the plain beam
/// (clamped, n = 1: r = 4.730041).

namespace strandyn::exact {

struct TensionedBeam {
  double tension = 0;          ///< [N]
  double EI = 0;               ///< [N m^2]
  double mass_per_length = 0;  ///< [kg/m]
  double length = 0;           ///< [m]
};

enum class BeamEnds { pinned, clamped };

/// A mode shape at one place, for an antinode of 1.
struct ShapeAt {
  double value = 0;      ///< [-]
  double slope = 0;      ///< [1/m]
  double curvature = 0;  ///< [1/m^2] second derivative
};

/// Mode n = 1, 2, ... of a tensioned beam. The shape is scaled so that its largest antinode is 1 in size and the first
/// antinode from x = 0 is positive.
class TensionedBeamMode {
 public:
  TensionedBeamMode(const TensionedBeam& beam, BeamEnds ends, int n);

  double frequency() const { return frequency_; }     ///< [Hz]
  double wavenumber() const { return r_ / length_; }  ///< [1/m] of the trigonometric part
  ShapeAt at(double x) const;                         ///< 0 <= x <= L [m]; value exact to rounding of the antinode

 private:
  ShapeAt unscaled(double z) const;

  int n_;
  BeamEnds ends_;
  double length_;
  double p_;  // of the hyperbolic part, times L
  double r_;  // of the trigonometric part, times L
  double frequency_;
  double scale_ = 1;
};

}  // namespace strandyn::exact
