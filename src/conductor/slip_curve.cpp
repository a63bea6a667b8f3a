#include "strandyn/conductor/slip_curve.hpp"

#include <cmath>

namespace strandyn::conductor {

namespace {

/// Traction g of a line contact at x = g + (1 - g) ln(1 - g)/(2 Lambda), which grows with it.
double line_traction(double x, double logarithm) {
  if (x >= 1) return 1;
  double low = 0;
  double high = 1;
  for (;;) {
    const double g = (low + high) / 2;
    if (g <= low || g >= high) return g;
    const double slip = g + (1 - g) * std::log1p(-g) / (2 * logarithm);
    (slip < x ? low : high) = g;
  }
}

/// -(g + ln(1 - g)) without the cancellation of small g.
double logarithm_beyond_linear(double g) {
  if (g > 0.05) return -(g + std::log1p(-g));
  double sum = 0;
  for (int n = 12; n >= 2; --n) sum = sum * g + 1.0 / n;
  return sum * g * g;
}

}  // namespace

SlipCurve SlipCurve::spot() {
  return {};
}

SlipCurve SlipCurve::line(double logarithm) {
  SlipCurve curve;
  curve.logarithm_ = logarithm;
  return curve;
}

double SlipCurve::traction(double x) const {
  return logarithm_ == 0 ? 1 - (1 - x) * std::sqrt(1 - x) : line_traction(x, logarithm_);
}

double SlipCurve::slope(double x) const {
  if (logarithm_ == 0) return 1.5 * std::sqrt(1 - x);
  const double g = line_traction(x, logarithm_);
  return g == 1 ? 0 : 1 / (1 - (1 + std::log1p(-g)) / (2 * logarithm_));
}

double SlipCurve::loss_moment(double x) const {
  // Both g - x g', rearranged so that its leading x^2 does not come from a difference.
  if (logarithm_ == 0) {
    const double root = std::sqrt(1 - x);
    return x * x * (2 + root) / (2 * (1 + root) * (1 + root));
  }
  const double g = line_traction(x, logarithm_);
  return g == 1 ? 1 : slope(x) / (2 * logarithm_) * logarithm_beyond_linear(g);
}

/// A multiple of its inverse, up to one, is a double; and so is any sum of them.
constexpr double digits_of_one = 0x1p52;

double grading_ratio(const ChainPlan& plan) {
  return std::pow(plan.smallest_slip, -1.0 / (plan.springs - 2));
}

SpringChain spring_chain(const SlipCurve& curve, const ChainPlan& plan) {
  // Cells of x between 0, ..., r^-(3/2 + phase), r^-(1/2 + phase), x_m, 1: one spring each, with its cell's part of the
  // limit. In a graded chain whose phase takes all values the springs are spread evenly; the place p in a cell at which
  // the loss of the spread chain is the curve's follows from the mean of phi over ln(r): p^2 = (r^2 - 1)/(2 ln r).
  const auto graded = static_cast<std::size_t>(plan.springs) - 2;
  const double r = grading_ratio(plan);
  const double place = std::sqrt((r * r - 1) / (2 * std::log(r)));
  const double first_stiffness = curve.slope(0);
  SpringChain chain;
  double low = 0;
  double stiffness_below = 0;
  for (std::size_t i = 0; i < graded; ++i) {
    const double high = std::pow(r, -(0.5 + plan.phase + static_cast<double>(graded - 1 - i)));
    const double x = i == 0 ? high / 2 : place * low;
    chain.limit.push_back(curve.loss_moment(high) - curve.loss_moment(low));
    chain.stiffness.push_back(chain.limit.back() / x / first_stiffness);
    stiffness_below += chain.stiffness.back();
    low = high;
  }
  // The last stretch to full slip, where curves bend most, in two: the last spring has its cell's limit and stiffness,
  // the one before makes both sums whole.
  const double middle = 1 - (1 - low) / 4;
  const double last_stiffness = curve.slope(middle) / first_stiffness;
  chain.limit.push_back(curve.loss_moment(middle) - curve.loss_moment(low));
  chain.stiffness.push_back(1 - stiffness_below - last_stiffness);
  chain.limit.push_back(1 - curve.loss_moment(middle));
  chain.stiffness.push_back(last_stiffness);
  for (double& phi : chain.limit) phi = std::nearbyint(phi * digits_of_one) / digits_of_one;
  return chain;
}

}  // namespace strandyn::conductor
