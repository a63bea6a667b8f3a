#include "strandyn/observe/ledger.hpp"

namespace strandyn::observe {

Account interpolate(const Account& from, const Account& to, double part) {
  const auto mix = [part](double a, double b) { return a + part * (b - a); };
  return {.external_work = mix(from.external_work, to.external_work),
          .kinetic = mix(from.kinetic, to.kinetic),
          .elastic = mix(from.elastic, to.elastic),
          .friction = mix(from.friction, to.friction),
          .viscous = mix(from.viscous, to.viscous),
          .quadrature_error = mix(from.quadrature_error, to.quadrature_error),
          .internal_work = mix(from.internal_work, to.internal_work),
          .initial_kinetic = to.initial_kinetic};
}

void Ledger::begin(const system::System& system, const solver::StepRecord& initial) {
  u_ = initial.u;
  external_ = internal_ = next_external_ = next_internal_ = system::Vector::Zero(u_.size());
  system.external_force(initial.time, external_.data());
  system.internal_force(u_.data(), internal_.data());
  drag_power_ = system.drag_power(initial.v.data());
  initial_elastic_ = initial.accepted.elastic;
  now_ = {};
  now_.initial_kinetic = now_.kinetic = system.kinetic_energy(initial.u.data(), initial.v.data());
}

void Ledger::step(const system::System& system, const solver::StepRecord& record) {
  system.external_force(record.time, next_external_.data());
  system.internal_force(record.u.data(), next_internal_.data());
  const double drag_power = system.drag_power(record.v.data());

  now_.external_work += 0.5 * (external_ + next_external_).dot(record.u - u_);
  now_.internal_work += 0.5 * (internal_ + next_internal_).dot(record.u - u_);
  now_.kinetic = system.kinetic_energy(record.u.data(), record.v.data());
  now_.elastic = record.accepted.elastic - initial_elastic_;
  now_.friction += record.accepted.friction;
  now_.quadrature_error += record.accepted.quadrature_error;
  now_.viscous += 0.5 * record.step * (drag_power_ + drag_power);

  u_ = record.u;
  external_.swap(next_external_);
  internal_.swap(next_internal_);
  drag_power_ = drag_power;
}

}  // namespace strandyn::observe
