#include "correction_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace strandyn::solver {

CorrectionTest::CorrectionTest(double tolerance, std::size_t unknowns)
    : tolerance_(tolerance), last_(system::Vector::Zero(static_cast<Eigen::Index>(unknowns))) {}

Verdict CorrectionTest::judge(int iteration, const double* correction) {
  const Eigen::Map<const system::Vector> du(correction, last_.size());
  const double norm = du.norm();
  const double before = previous_norm_;
  previous_norm_ = norm;
  if (!std::isfinite(norm)) return Verdict::lost;
  if (norm <= 0.1 * tolerance_) return Verdict::arrived;
  if (iteration == 0) return Verdict::on_the_way;
  if (norm <= tolerance_) return Verdict::arrived;
  last_ = du;
  const double rate = norm / before;
  if (rate < 0.5 && norm * rate / (1 - rate) <= 0.1 * tolerance_) return Verdict::arrived;
  return iteration >= 3 && rate > 2 ? Verdict::lost : Verdict::on_the_way;
}

std::string CorrectionTest::worst_unknowns(const model::Model& model) const {
  std::vector<std::size_t> order(static_cast<std::size_t>(last_.size()));
  std::iota(order.begin(), order.end(), 0);
  const auto size = [&](std::size_t i) { return std::abs(last_(static_cast<Eigen::Index>(i))); };
  const std::size_t shown = std::min<std::size_t>(10, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(shown), order.end(),
                    [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
  std::string text;
  for (std::size_t i = 0; i < shown && size(order[i]) > 0; ++i) {
    text += fmt::format("{}{} ({:.2g})", i == 0 ? "" : ", ", model.unknown_name(order[i]), size(order[i]));
  }
  return text;
}

}  // namespace strandyn::solver
