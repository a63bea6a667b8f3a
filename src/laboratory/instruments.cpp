#include "strandyn/laboratory/instruments.hpp"

#include <cmath>
#include <numbers>

namespace strandyn::laboratory {

using Complex = std::complex<double>;
using section::Component;
using std::numbers::pi;

namespace {

constexpr std::array axes = {Component::bending2, Component::bending3};

/// exp(-i (w t + phase - pi/2))
Complex turned_back(const Drive& drive, double time) {
  return std::polar(1.0, pi / 2 - drive.phase - 2 * pi * drive.frequency * time);
}

}  // namespace

CyclePhasors::Sample CyclePhasors::sample(const observe::StepRecord& record) const {
  const Complex turn = turned_back(drive_, record.time);
  return {.modal = bench_.modal_coordinate(record.u) * turn, .driven = bench_.driven_displacement(record.u) * turn};
}

void CyclePhasors::begin(const system::System&, const observe::StepRecord& initial) {
  before_ = sample(initial);
  end_ = {.u = initial.u, .v = initial.v};
}

void CyclePhasors::step(const system::System&, const observe::StepRecord& record) {
  const Sample now = sample(record);
  const double weight = record.step * drive_.frequency;  // half a step of 2/T
  sum_.modal += weight * (before_.modal + now.modal);
  sum_.driven += weight * (before_.driven + now.driven);
  before_ = now;
  end_.u = record.u;
  end_.v = record.v;
  constexpr double rounding = 1e-9;
  if (record.time * drive_.frequency < static_cast<double>(modal_.size() + 1) - rounding) return;
  modal_.push_back(sum_.modal);
  driven_.push_back(sum_.driven);
  sum_ = {};
}

void SteadyPhasors::begin(const system::System& system, const observe::StepRecord& initial) {
  const auto points = static_cast<Eigen::Index>(system.committed_strains().points());
  motion_ = Eigen::VectorXcd::Zero(initial.u.size());
  curvature_ = moment_ = Eigen::MatrixXcd::Zero(points, axes.size());
}

void SteadyPhasors::step(const system::System& system, const observe::StepRecord& record) {
  const Complex turn = record.step * turned_back(drive_, record.time);
  weight_ += record.step / 2;
  force_ += turn * bench_.shaker_force(cycles_.ledger().external_force());
  driven_ += turn * bench_.driven_displacement(record.u);
  motion_ += turn * record.u;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const AlignedVector& curvature = system.committed_strains()[axes[axis]];
    const AlignedVector& moment = system.last_stresses()[axes[axis]];
    if (curvature.empty()) continue;
    for (Eigen::Index point = 0; point < curvature_.rows(); ++point) {
      curvature_(point, static_cast<Eigen::Index>(axis)) += turn * curvature[static_cast<std::size_t>(point)];
      moment_(point, static_cast<Eigen::Index>(axis)) += turn * moment[static_cast<std::size_t>(point)];
    }
  }
}

}  // namespace strandyn::laboratory
