#include "periodic_balance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace strandyn::solver {

using Eigen::Index;
using Eigen::MatrixXd;
using section::Component;
using section::Field;
using system::System;
using system::Vector;

namespace {

constexpr system::At at_rest{.time = 0};

std::size_t find_place(const System& system, const Place& place, bool held, const char* what) {
  const model::Model& model = system.model();
  const auto i = place.node < model.nodes.size() ? model.index(place.node, place.unknown) : std::nullopt;
  if (!i) {
    throw std::invalid_argument(fmt::format("periodic response: the chain has no {} of node {} for the {}",
                                            model::name_of(place.unknown), place.node, what));
  }
  if (system.is_held(*i) != held) {
    throw std::invalid_argument(fmt::format("periodic response: the {}, {}, is {}", what, model.unknown_name(*i),
                                            held ? "not held" : "held by a support"));
  }
  return *i;
}

section::Dimension dimension_of(const Field& field) {
  return field[Component::bending3].empty() ? section::Dimension::planar : section::Dimension::spatial;
}

}  // namespace

HarmonicBalance::HarmonicBalance(const System& system, const Vector& rest, const PeriodicSetup& setup,
                                 const PeriodicOptions& options)
    : system_(system),
      rest_(rest),
      setup_(setup),
      options_(options),
      fourier_(options.harmonics, options.samples),
      axes_({Component::bending2}),
      M_(system.make_matrix()),
      C_(system.make_matrix()) {
  drive_ = find_place(system, setup.drive, setup.kind == DriveKind::motion, "drive");
  control_ = find_place(system, setup.control, false, "control");
  const Field strains = system.committed_strains();
  if (dimension_of(strains) == section::Dimension::spatial) axes_.push_back(Component::bending3);
  tangents_ = section::TangentField(dimension_of(strains), strains.points());
  Field stresses = strains;
  system.model().law->respond(system.history(), strains, stresses, &tangents_);
  unstressed_ = Field(dimension_of(strains), strains.points());
  if (!system.model().bodies.empty()) {
    springs_ = system.make_matrix();
    system.stiffness_of(unstressed_, section::TangentField(dimension_of(strains), strains.points()), rest.data(),
                        *springs_);
  }
  double along = 0;
  for (std::size_t p = 0; p < strains.points(); ++p) {
    const double length = system.point_length(p) / system.model().unstressed_length();
    places_.push_back(along + length / 2);
    along += length;
  }
  const Vector still = system.make_vector();
  const system::State motion{.u = rest.data(), .v = still.data(), .a = still.data()};
  system.add_inertia_and_drag(motion, {.acceleration = 1}, M_);
  system.add_inertia_and_drag(motion, {.velocity = 1}, C_);
  for (std::size_t i = 0; i < system.unknowns(); ++i) {
    if (!system.is_held(i) && !system.has_mass(i)) C_.pin(i, 0);  // it has no velocity
  }
  if (system.model().surroundings) {
    A_ = system.make_matrix();
    system.air_on_chain().add_tangent({.linear = 1}, still.data(), 1, *A_);
    for (std::size_t i = 0; i < system.unknowns(); ++i) {
      if (!system.is_held(i) && !system.has_mass(i)) A_->pin(i, 0);
    }
  }
  total_mass_ = system.model().inertia.mass * system.model().unstressed_length();
  for (const model::Body& body : system.model().bodies) total_mass_ += body.mass;
}

HarmonicBalance::Swing HarmonicBalance::swing(const PeriodicPoint& point) const {
  const MatrixXd rate = point.omega * Fourier::derivative(point.x);
  const MatrixXd second = point.omega * Fourier::derivative(rate);
  const MatrixXd weights = fourier_.basis().transpose();
  Swing swing{.u = (point.x * weights).colwise() + rest_, .v = rate * weights, .a = second * weights};
  for (std::size_t i = 0; i < system_.unknowns(); ++i) {
    if (system_.is_held(i) || system_.has_mass(i)) continue;
    swing.v.row(static_cast<Index>(i)).setZero();
    swing.a.row(static_cast<Index>(i)).setZero();
  }
  return swing;
}

MatrixXd HarmonicBalance::inertia(const PeriodicPoint& point) const {
  const Swing s = swing(point);
  const air::AirForce other = other_air(point);
  MatrixXd force = MatrixXd::Zero(s.u.rows(), s.u.cols());
  for (Index j = 0; j < force.cols(); ++j) {
    system_.add_inertia_and_drag({.u = s.u.col(j).data(), .v = s.v.col(j).data(), .a = s.a.col(j).data()},
                                 force.col(j).data());
    if (A_ && !other.is_none()) system_.air_on_chain().add_force(other, s.v.col(j).data(), force.col(j).data());
  }
  MatrixXd harmonics = force * fourier_.projection().transpose();
  if (!A_) return harmonics;
  const MatrixXd rate = point.omega * Fourier::derivative(point.x);
  Vector on_nodes = system_.make_vector();
  for (Index a = 1; a < harmonics.cols(); ++a) {
    const Vector velocity = rate.col(a);
    A_->multiply(velocity.data(), on_nodes.data());
    harmonics.col(a) += linear_air(point, static_cast<int>(a + 1) / 2).linear * on_nodes;
  }
  return harmonics;
}

BalanceEvaluation HarmonicBalance::evaluate(const PeriodicPoint& point) const {
  const Swing s = swing(point);
  BalanceEvaluation at;
  at.strains.assign(static_cast<std::size_t>(s.u.cols()), system_.committed_strains());
  for (std::size_t j = 0; j < at.strains.size(); ++j) {
    system_.strains(s.u.col(static_cast<Index>(j)).data(), at.strains[j]);
  }
  at.loops = lead_around(*system_.model().law, system_.history(), at.strains,
                         {.max_cycles = options_.max_cycles, .closure = options_.closure, .stop = options_.stop});
  add_material(point, at);
  const std::vector<Field>& stresses = at.with_metal.empty() ? at.loops.stresses : at.with_metal;
  MatrixXd force(s.u.rows(), s.u.cols());
  Vector load = system_.make_vector();
  for (Index j = 0; j < force.cols(); ++j) {
    system_.internal_force_of(stresses[static_cast<std::size_t>(j)], s.u.col(j).data(), force.col(j).data());
    system_.external_force(at_rest, s.u.col(j).data(), load.data());
    force.col(j) -= load;
  }
  at.force = force * fourier_.projection().transpose() + inertia(point);
  at.residual = at.force;
  for (std::size_t i = 0; i < system_.unknowns(); ++i) {
    if (system_.is_held(i)) at.residual.row(static_cast<Index>(i)) = point.x.row(static_cast<Index>(i));
  }
  at.residual(static_cast<Index>(drive_), 1) -= point.drive;
  return at;
}

MatrixXd HarmonicBalance::harmonics_of(const std::vector<Field>& fields, Component c, std::size_t p) const {
  Vector samples(fourier_.samples());
  for (Index j = 0; j < samples.size(); ++j) samples(j) = fields[static_cast<std::size_t>(j)][c][p];
  return fourier_.projection() * samples;
}

MatrixXd HarmonicBalance::fundamental_curvature(const BalanceEvaluation& at, std::size_t p) const {
  MatrixXd chi(2, static_cast<Index>(axes_.size()));
  for (Index c = 0; c < chi.cols(); ++c) {
    chi.col(c) = harmonics_of(at.strains, axes_[static_cast<std::size_t>(c)], p).col(0).segment(1, 2);
  }
  return chi;
}

MatrixXd HarmonicBalance::moments(const std::vector<Field>& stresses, std::size_t p) const {
  MatrixXd moment(fourier_.coefficients(), static_cast<Index>(axes_.size()));
  for (Index c = 0; c < moment.cols(); ++c) {
    moment.col(c) = harmonics_of(stresses, axes_[static_cast<std::size_t>(c)], p);
  }
  return moment;
}

SectionModel HarmonicBalance::secant_model(const BalanceEvaluation& at) const {
  SectionModel model{
      .mean = tangents_, .slipping = {}, .extra = {}, .places = places_, .coefficients = fourier_.coefficients()};
  for (std::size_t p = 0; p < at.loops.friction.size(); ++p) {
    if (at.loops.friction[p] == 0) continue;
    const MatrixXd chi = fundamental_curvature(at, p);
    const double secant = moments(at.loops.stresses, p).middleRows(1, 2).cwiseProduct(chi).sum() / chi.squaredNorm();
    for (Component c : axes_) model.mean(c, c)[p] = secant;
  }
  return model;
}

double HarmonicBalance::softening(const SectionModel& model) const {
  double largest = 0;
  for (Component c : axes_) {
    for (std::size_t p = 0; p < system_.committed_strains().points(); ++p) {
      largest = std::max(largest, 1 - model.mean(c, c)[p] / tangents_(c, c)[p]);
    }
  }
  return largest;
}

SectionModel HarmonicBalance::probed_model(const BalanceEvaluation& at) const {
  SectionModel model = secant_model(at);
  for (std::size_t p = 0; p < at.loops.friction.size(); ++p) {
    if (at.loops.friction[p] > 0) model.slipping.push_back(p);
  }
  const auto slipping = model.slipping.size();
  if (slipping == 0) return model;
  const auto axes = static_cast<Index>(axes_.size());
  const Index coefficients = fourier_.coefficients();
  std::vector<double> step(slipping);  // [1/m]
  std::vector<MatrixXd> moment(slipping);
  for (std::size_t s = 0; s < slipping; ++s) {
    const std::size_t p = model.slipping[s];
    step[s] = options_.probe * fundamental_curvature(at, p).norm();
    moment[s] = moments(at.loops.stresses, p);
    const double secant = model.mean(axes_.front(), axes_.front())[p];
    model.extra.emplace_back(-secant * MatrixXd::Identity(coefficients * axes, coefficients * axes));
  }
  // Once more around for each coefficient, a little of it added to all curvatures at a time.
  std::vector<Field> changed = at.strains;
  for (Index c = 0; c < axes; ++c) {
    const Component changed_axis = axes_[static_cast<std::size_t>(c)];
    for (Index b = 0; b < coefficients; ++b) {
      for (std::size_t j = 0; j < changed.size(); ++j) {
        auto& chi = changed[j][changed_axis];
        chi = at.strains[j][changed_axis];
        const double part = fourier_.basis()(static_cast<Index>(j), b);
        for (std::size_t s = 0; s < slipping; ++s) chi[model.slipping[s]] += part * step[s];
      }
      const SectionLoops loops =
          lead_around(*system_.model().law, system_.history(), changed,
                      {.max_cycles = at.loops.cycles, .closure = options_.closure, .stop = options_.stop});
      model.effort += loops.effort;
      for (std::size_t s = 0; s < slipping; ++s) {
        const MatrixXd answer = moments(loops.stresses, model.slipping[s]) - moment[s];
        model.extra[s].col(c * coefficients + b) += answer.reshaped() / step[s];
      }
    }
    for (std::size_t j = 0; j < changed.size(); ++j) changed[j][changed_axis] = at.strains[j][changed_axis];
  }
  return model;
}

std::optional<SectionModel> HarmonicBalance::carried_model(const SectionModel& other) const {
  if (other.coefficients < fourier_.coefficients()) return std::nullopt;
  SectionModel model{
      .mean = tangents_, .slipping = {}, .extra = {}, .places = places_, .coefficients = fourier_.coefficients()};
  const auto axes = static_cast<Index>(axes_.size());
  const Index mine = fourier_.coefficients();
  std::vector<std::size_t> rank(other.places.size(), other.slipping.size());  // among those that slip
  for (std::size_t s = 0; s < other.slipping.size(); ++s) rank[other.slipping[s]] = s;
  for (std::size_t p = 0; p < places_.size(); ++p) {
    const auto above = std::ranges::lower_bound(other.places, places_[p]);
    auto nearest = static_cast<std::size_t>(above - other.places.begin());
    if (nearest == other.places.size() ||
        (nearest > 0 && places_[p] - other.places[nearest - 1] < other.places[nearest] - places_[p])) {
      --nearest;
    }
    for (Component c : axes_) model.mean(c, c)[p] = other.mean(c, c)[nearest];
    if (rank[nearest] == other.slipping.size()) continue;
    const MatrixXd& theirs = other.extra[rank[nearest]];
    const Index their = theirs.rows() / axes;
    MatrixXd extra(mine * axes, mine * axes);
    for (Index r = 0; r < axes; ++r) {
      for (Index c = 0; c < axes; ++c) {
        extra.block(r * mine, c * mine, mine, mine) = theirs.block(r * their, c * their, mine, mine);
      }
    }
    model.slipping.push_back(p);
    model.extra.push_back(std::move(extra));
  }
  return model;
}

void HarmonicBalance::account(const PeriodicPoint& point, const BalanceEvaluation& at,
                              PeriodicSolution& solution) const {
  const auto d = static_cast<Index>(drive_);
  const double force_c = setup_.kind == DriveKind::force ? point.drive : at.force(d, 1);
  const double force_s = setup_.kind == DriveKind::force ? 0 : at.force(d, 2);
  solution.drive_force = {force_c, -force_s};
  solution.drive_power = point.omega / 2 * (force_c * point.x(d, 2) - force_s * point.x(d, 1));

  // Derivatives by angle of all harmonics that the samples hold, not only of those of the balance.
  const auto samples = static_cast<Index>(at.strains.size());
  const Fourier full = Fourier::of_all(samples);
  const MatrixXd to_rate = Fourier::derivative(full.projection().transpose()) * full.basis().transpose();
  const std::size_t points = at.strains.front().points();
  SectionLoss& loss = solution.sections;
  loss = {.loop_work = std::vector<double>(points),
          .friction = at.loops.friction,
          .quadrature_error = at.loops.quadrature_error,
          .material = {},
          .curvature_amplitude = std::vector<double>(points)};
  for (std::size_t c = 0; c < section::component_count; ++c) {
    const Component component{c};
    if (at.strains.front()[component].empty()) continue;
    const double step = 2 * std::numbers::pi / static_cast<double>(samples);
    const MatrixXd rate = samples_of(at.strains, component) * to_rate;
    const Vector work = step * samples_of(at.loops.stresses, component).cwiseProduct(rate).rowwise().sum();
    for (std::size_t p = 0; p < points; ++p) loss.loop_work[p] += work(static_cast<Index>(p));
  }
  for (std::size_t p = 0; p < points; ++p) {
    loss.curvature_amplitude[p] = fundamental_curvature(at, p).norm();
    const double length = system_.point_length(p);
    solution.loop_work += length * loss.loop_work[p];
    solution.friction += length * loss.friction[p];
    solution.quadrature_error += length * loss.quadrature_error[p];
  }
  const MatrixXd v = swing(point).v;
  const double step = 2 * std::numbers::pi / point.omega / static_cast<double>(samples);
  for (Index j = 0; j < samples; ++j) {
    const system::ViscousLoss power = system_.viscous_power(v.col(j).data());
    solution.viscous = system::of_each_term([&](auto term) { return solution.viscous.*term + step * power.*term; });
  }
  account_for_air(point, solution);
  account_for_material(point, at, solution);
}

}  // namespace strandyn::solver
