#pragma once
/// \file The catenary: an inextensible, perfectly flexible cable under its weight, supports at different heights.
///
///     y(x) = a cosh((x - x_0)/a) + const,   a = H/w,   sqrt(S^2 - h^2) = 2 a sinh(l/(2 a))              [Irvine1981]
///
/// Sag and lengths are formed without differences of large cosines: a span of a metre at any tension keeps its digits.
/// Limits: w l << H gives the parabola, sag w l^2/(8 H), S = l + 8 sag^2/(3 l) for a level span.

namespace strandyn::exact {

/// Where the cable hangs and what it weighs.
struct CatenarySpan {
  double span = 0;               ///< [m] horizontal distance l of the supports
  double height_difference = 0;  ///< [m] h, right support above the left one
  double weight_per_length = 0;  ///< [N/m] of cable, > 0
};

class Catenary {
 public:
  static Catenary from_horizontal_tension(const CatenarySpan& span, double horizontal_tension);  ///< [N] > 0
  /// [m] of cable between the supports; greater than their distance.
  static Catenary from_length(const CatenarySpan& span, double length);

  double horizontal_tension() const;  ///< [N]
  double length() const;              ///< [m] of cable between the supports
  double sag() const;                 ///< [m] below the chord at midspan, vertically
  double height(double x) const;      ///< [m] above the left support, 0 <= x <= l [m]
  double slope(double x) const;       ///< [-] dy/dx
  double tension(double x) const;     ///< [N] along the cable

 private:
  Catenary(const CatenarySpan& span, double a);

  CatenarySpan span_;
  double a_;         // [m] H/w
  double midslope_;  // [-] asinh of the slope at midspan: (l/2 - x_0)/a
};

}  // namespace strandyn::exact
