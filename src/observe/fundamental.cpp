#include "strandyn/observe/fundamental.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::observe {

void Fundamental::archive(Archive& a) {
  a(count_, rest_, before_, time_before_, sum_, kept_);
  if (!a.reads()) return;
  const bool whole = std::ranges::all_of(kept_, [this](const auto& motion) { return motion.size() == rest_.size(); });
  if (!whole || kept_.size() != std::min(count_, options_.kept)) {
    throw InputError("the motions of its last cycles are not as many as they must be");
  }
}

Eigen::VectorXcd Fundamental::turned_back(const StepRecord& record) const {
  const double angle = 2 * std::numbers::pi * record.time / options_.period;
  return std::polar(1.0, -angle) * (record.u - rest_);
}

void Fundamental::begin(const system::System&, const StepRecord& initial) {
  rest_ = initial.u;
  before_ = sum_ = Eigen::VectorXcd::Zero(rest_.size());
  time_before_ = initial.time;
}

void Fundamental::step(const system::System&, const StepRecord& record) {
  const Eigen::VectorXcd now = turned_back(record);
  sum_ += (record.time - time_before_) / options_.period * (before_ + now);  // half a step of 2/T
  before_ = now;
  time_before_ = record.time;
  constexpr double rounding = 1e-9;
  if (record.time < (static_cast<double>(count_ + 1) - rounding) * options_.period) return;
  ++count_;
  kept_.push_back(sum_);
  if (kept_.size() > options_.kept) kept_.pop_front();
  sum_.setZero();
}

Eigen::VectorXcd Fundamental::motion() const {
  if (kept_.empty()) return {};
  const Eigen::VectorXcd& last = kept_.back();
  Eigen::VectorXcd mean = Eigen::VectorXcd::Zero(last.size());
  for (const Eigen::VectorXcd& cycle : kept_) {
    const std::complex<double> along = cycle.dot(last);
    const double weight = 1 / static_cast<double>(kept_.size());
    mean += weight * (std::abs(along) > 0 ? along / std::abs(along) : 1) * cycle;
  }
  return mean;
}

}  // namespace strandyn::observe
