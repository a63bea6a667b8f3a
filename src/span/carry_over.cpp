#include "strandyn/span/carry_over.hpp"

#include <algorithm>

namespace strandyn::span {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using model::Unknown;

namespace {

struct Interval {
  Index left = 0;  ///< node
  double t = 0;    ///< [-] of the way to the next one
  double h = 0;    ///< [m]
};

Interval interval_of(const std::vector<double>& arc, double s) {
  const auto above = std::upper_bound(arc.begin(), arc.end(), s);
  const auto right = std::clamp<std::ptrdiff_t>(above - arc.begin(), 1, static_cast<std::ptrdiff_t>(arc.size()) - 1);
  const double a = arc[static_cast<std::size_t>(right) - 1];
  const double h = arc[static_cast<std::size_t>(right)] - a;
  return {.left = right - 1, .t = std::clamp((s - a) / h, 0.0, 1.0), .h = h};
}

}  // namespace

MatrixXd carry_over(const model::Model& from, const MatrixXd& motion, const model::Model& to) {
  const std::vector<double> old_arc = model::arc_lengths(from), arc = model::arc_lengths(to);
  const auto per_node = static_cast<Index>(to.unknowns_per_node());
  const auto deflection = to.index(0, Unknown::y), rotation = to.index(0, Unknown::rotation_z);
  MatrixXd result(per_node * static_cast<Index>(arc.size()), motion.cols());
  const double scale = old_arc.back() / arc.back();
  for (std::size_t node = 0; node < arc.size(); ++node) {
    const auto [left, t, h] = interval_of(old_arc, scale * arc[node]);
    const auto at = [&](Index n, Index k) -> RowVectorXd { return motion.row(n * per_node + k); };
    const Index own = static_cast<Index>(node) * per_node;
    for (Index k = 0; k < per_node; ++k) {
      result.row(own + k) = (1 - t) * at(left, k) + t * at(left + 1, k);
    }
    if (!deflection || !rotation) continue;
    const auto y = static_cast<Index>(*deflection), r = static_cast<Index>(*rotation);
    const double s = 1 - t;
    result.row(own + y) = s * s * (1 + 2 * t) * at(left, y) + t * t * (1 + 2 * s) * at(left + 1, y) +
                          s * t * h * (s * at(left, r) - t * at(left + 1, r));
    result.row(own + r) = 6 * s * t / h * (at(left + 1, y) - at(left, y)) + s * (1 - 3 * t) * at(left, r) +
                          t * (1 - 3 * s) * at(left + 1, r);
  }
  return result;
}

}  // namespace strandyn::span
