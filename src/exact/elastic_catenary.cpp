#include "strandyn/exact/elastic_catenary.hpp"

#include <algorithm>
#include <cmath>

namespace strandyn::exact {

ElasticCatenary::Place ElasticCatenary::at(double s) const {
  const double w = span_.weight_per_length;
  const double begin = -V_ / H_;  // slopes
  const double here = (w * s - V_) / H_;
  // Differences of asinh and of the root, written so that small ones keep their digits.
  const double root_begin = std::hypot(1, begin);
  const double root_here = std::hypot(1, here);
  const double rise = (here - begin) * (here + begin) / (root_here + root_begin);
  const double turn = std::asinh(here) - std::asinh(begin);
  return {.x = H_ * s / EA_ + H_ / w * turn,
          .y = s / EA_ * (w * s / 2 - V_) + H_ / w * rise,
          .angle = std::atan(here),
          .tension = H_ * root_here};
}

/// For a given H the end point must be the right support: two unknowns, the length and V. The inextensible catenary is
/// near, and Newton's method does the rest.
ElasticCatenary::ElasticCatenary(const CatenarySpan& span, double EA, double H) : span_(span), EA_(EA), H_(H) {
  const double w = span.weight_per_length;
  const Catenary start = Catenary::from_horizontal_tension(span, H);
  length_ = start.length() / (1 + H / EA);
  V_ = -H * start.slope(0);
  for (int i = 0; i < 100; ++i) {
    const Place end = at(length_);
    const double slope = std::tan(end.angle);
    const double dx = span.span - end.x;
    const double dy = span.height_difference - end.y;
    // Derivatives of the end by length and by V.
    const double x_s = H / EA + 1 / std::hypot(1, slope);
    const double y_s = H * slope / EA + slope / std::hypot(1, slope);
    const double begin = -V_ / H;
    const double x_V = (1 / std::hypot(1, begin) - 1 / std::hypot(1, slope)) / w;
    const double y_V = -length_ / EA + (begin / std::hypot(1, begin) - slope / std::hypot(1, slope)) / w;
    const double determinant = x_s * y_V - x_V * y_s;
    const double ds = (dx * y_V - dy * x_V) / determinant;
    const double dV = (x_s * dy - y_s * dx) / determinant;
    length_ += std::max(ds, -length_ / 2);
    V_ += dV;
    if (std::abs(ds) <= 1e-15 * length_ && std::abs(dV) <= 1e-14 * (std::abs(V_) + w * length_)) break;
  }
}

ElasticCatenary ElasticCatenary::from_horizontal_tension(const CatenarySpan& span, double EA,
                                                         double horizontal_tension) {
  return {span, EA, horizontal_tension};
}

ElasticCatenary ElasticCatenary::from_unstressed_length(const CatenarySpan& span, double EA, double unstressed_length) {
  // The more tension, the less cable. A cable much longer than its span has a tension that is a tiny part of its
  // weight.
  const double chord = std::hypot(span.span, span.height_difference);
  const double weight = span.weight_per_length * unstressed_length;
  const double stretched = EA * std::max(0.0, chord / unstressed_length - 1);
  double low = std::log(1e-12 * weight);
  double high = std::log(4 * stretched + 1e3 * weight + 1e-3 * EA);
  for (int i = 0; i < 200 && high - low > 1e-15 * std::abs(high); ++i) {
    const double middle = 0.5 * (low + high);
    // A tension so small that the catenary's length overflows is too small as well.
    (ElasticCatenary(span, EA, std::exp(middle)).length_ <= unstressed_length ? high : low) = middle;
  }
  return {span, EA, std::exp(0.5 * (low + high))};
}

double ElasticCatenary::sag() const {
  double low = 0;
  double high = length_;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (at(middle).x < span_.span / 2 ? low : high) = middle;
  }
  return span_.height_difference / 2 - at(0.5 * (low + high)).y;
}

}  // namespace strandyn::exact
