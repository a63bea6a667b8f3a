#pragma once
/// \file The elastic catenary: a perfectly flexible cable that stretches, under its weight, between two supports.
///
/// At the unstressed length s from the left support, with V the upward force of that support:          [Irvine1981]
///     x(s) = H s/EA + (H/w) [asinh((w s - V)/H) + asinh(V/H)]
///     y(s) = (s/EA) (w s/2 - V) + (H/w) [sqrt(1 + ((w s - V)/H)^2) - sqrt(1 + (V/H)^2)]
/// Limits: EA -> infinity is the catenary; w l << H is the parabola with the strain H/EA.

#include "strandyn/exact/catenary.hpp"

namespace strandyn::exact {

class ElasticCatenary {
 public:
  /// `span.weight_per_length` is [N/m] of unstressed cable; EA [N]; the horizontal tension [N] > 0.
  static ElasticCatenary from_horizontal_tension(const CatenarySpan& span, double EA, double horizontal_tension);
  /// [m] of unstressed cable, of any length: shorter than the chord it is stretched, longer it hangs.
  static ElasticCatenary from_unstressed_length(const CatenarySpan& span, double EA, double unstressed_length);

  double horizontal_tension() const { return H_; }      ///< [N]
  double unstressed_length() const { return length_; }  ///< [m]
  double sag() const;                                   ///< [m] below the chord at midspan, vertically

  /// A place of the cable, by its unstressed length from the left support.
  struct Place {
    double x = 0;        ///< [m]
    double y = 0;        ///< [m] above the left support
    double angle = 0;    ///< [rad] of the tangent to the horizontal
    double tension = 0;  ///< [N]
  };
  Place at(double s) const;

 private:
  ElasticCatenary(const CatenarySpan& span, double EA, double H);

  CatenarySpan span_;
  double EA_;
  double H_;
  double length_ = 0;
  double V_ = 0;
};

}  // namespace strandyn::exact
