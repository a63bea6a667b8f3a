// What still air and the metal of the wires add to the balance: each harmonic at its own frequency.

#include <cmath>

#include "periodic_balance.hpp"

namespace strandyn::solver {

using Eigen::Index;
using Eigen::MatrixXd;
using section::ComplexStiffness;
using section::Component;
using section::Field;
using system::Vector;

namespace {

constexpr double turn = 2 * std::numbers::pi;

air::AirForce air_at(const model::Model& model, double frequency) {
  return air::force_at(model.surroundings->air, model.surroundings->diameter, frequency);
}

}  // namespace

MatrixXd samples_of(const std::vector<Field>& fields, Component c) {
  MatrixXd samples(static_cast<Index>(fields.front().points()), static_cast<Index>(fields.size()));
  for (Index j = 0; j < samples.cols(); ++j) {
    samples.col(j) = Eigen::Map<const Vector>(fields[static_cast<std::size_t>(j)][c].data(), samples.rows());
  }
  return samples;
}

air::AirForce HarmonicBalance::linear_air(const PeriodicPoint& point, int k) const {
  return {.linear = air_at(system_.model(), k * point.omega / turn).linear};
}

air::AirForce HarmonicBalance::other_air(const PeriodicPoint& point) const {
  if (!A_) return {};
  air::AirForce force = air_at(system_.model(), point.omega / turn);
  force.linear = 0;
  return force;
}

void HarmonicBalance::add_material(const PeriodicPoint& point, BalanceEvaluation& at) const {
  const section::MaterialBranches& branches = system_.model().material;
  if (branches.empty()) return;
  at.with_metal = at.loops.stresses;
  const auto samples = static_cast<Index>(at.strains.size());
  const Fourier full = Fourier::of_all(samples);
  for (std::size_t component = 0; component < section::component_count; ++component) {
    const Component c{component};
    if (at.strains.front()[c].empty()) continue;
    MatrixXd answer = MatrixXd::Zero(full.coefficients(), full.coefficients());
    for (Index a = 1; a < answer.cols(); a += 2) {
      const ComplexStiffness E = section::stiffness_at(branches, c, static_cast<double>((a + 1) / 2) * point.omega);
      answer(a, a) = answer(a + 1, a + 1) = E.storage;
      answer(a, a + 1) = E.loss;
      answer(a + 1, a) = -E.loss;
    }
    const MatrixXd weights = full.projection().transpose() * answer.transpose() * full.basis().transpose();
    const MatrixXd stress = samples_of(at.strains, c) * weights;
    for (Index j = 0; j < samples; ++j) {
      auto& sum = at.with_metal[static_cast<std::size_t>(j)][c];
      for (Index p = 0; p < stress.rows(); ++p) sum[static_cast<std::size_t>(p)] += stress(p, j);
    }
  }
}

void HarmonicBalance::account_for_air(const PeriodicPoint& point, PeriodicSolution& solution) const {
  if (!A_) return;
  solution.air_by_node.assign(system_.model().nodes.size(), 0.0);
  const double period = turn / point.omega;
  const auto add = [&](const std::vector<double>& power, double weight) {
    for (std::size_t node = 0; node < power.size(); ++node) {
      solution.air_by_node[node] += weight * period * power[node];
      solution.air += weight * period * power[node];
    }
  };
  const system::AirOnChain& air = system_.air_on_chain();
  MatrixXd rate = point.omega * Fourier::derivative(point.x);
  for (std::size_t i = 0; i < system_.unknowns(); ++i) {
    if (!system_.is_held(i) && !system_.has_mass(i)) rate.row(static_cast<Index>(i)).setZero();
  }
  for (Index a = 1; a < rate.cols(); ++a) {
    const Vector velocity = rate.col(a);
    add(air.power_by_node(linear_air(point, static_cast<int>(a + 1) / 2), velocity.data()), 0.5);
  }
  const air::AirForce other = other_air(point);
  if (other.is_none()) return;
  const MatrixXd v = swing(point).v;
  for (Index j = 0; j < v.cols(); ++j) {
    add(air.power_by_node(other, v.col(j).data()), 1 / static_cast<double>(v.cols()));
  }
}

void HarmonicBalance::account_for_material(const PeriodicPoint& point, const BalanceEvaluation& at,
                                           PeriodicSolution& solution) const {
  const std::size_t points = at.strains.front().points();
  solution.sections.material.assign(points, 0.0);
  const section::MaterialBranches& branches = system_.model().material;
  if (branches.empty()) return;
  const Fourier full = Fourier::of_all(static_cast<Index>(at.strains.size()));
  for (std::size_t component = 0; component < section::component_count; ++component) {
    const Component c{component};
    if (at.strains.front()[c].empty()) continue;
    const MatrixXd coefficients = samples_of(at.strains, c) * full.projection().transpose();
    for (Index a = 1; a < coefficients.cols(); ++a) {
      const double omega = static_cast<double>((a + 1) / 2) * point.omega;
      const double factor =
          std::numbers::pi * static_cast<double>((a + 1) / 2) * section::stiffness_at(branches, c, omega).loss;
      for (std::size_t p = 0; p < points; ++p) {
        const double strain = coefficients(static_cast<Index>(p), a);
        solution.sections.material[p] += factor * strain * strain;
      }
    }
  }
  for (std::size_t p = 0; p < points; ++p) {
    solution.material += system_.point_length(p) * solution.sections.material[p];
  }
}

}  // namespace strandyn::solver
