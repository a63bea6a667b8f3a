#include "strandyn/observe/ledger.hpp"

namespace strandyn::observe {

namespace {

system::State state_of(const StepRecord& record) {
  return {.u = record.u.data(), .v = record.v.data(), .a = record.a.data()};
}

}  // namespace

Account interpolate(const Account& from, const Account& to, double part) {
  const auto mix = [part](double a, double b) { return a + part * (b - a); };
  return {.external_work = mix(from.external_work, to.external_work),
          .wind = mix(from.wind, to.wind),
          .kinetic = mix(from.kinetic, to.kinetic),
          .elastic = mix(from.elastic, to.elastic),
          .friction = mix(from.friction, to.friction),
          .material = mix(from.material, to.material),
          .viscous = system::of_each_term([&](auto term) { return mix(from.viscous.*term, to.viscous.*term); }),
          .air = mix(from.air, to.air),
          .attached = mix(from.attached, to.attached),
          .quadrature_error = mix(from.quadrature_error, to.quadrature_error),
          .internal_work = mix(from.internal_work, to.internal_work),
          .initial_kinetic = to.initial_kinetic};
}

void Ledger::begin(const system::System& system, const StepRecord& initial) {
  u_ = initial.u;
  external_ = initial.external;
  internal_ = initial.internal;
  if (external_.size() != u_.size()) throw ComputationError("a ledger needs the forces of every step");
  power_ = system.viscous_power(initial.v.data());
  air_power_ = system.air_power(initial.v.data());
  wind_power_ = system.wind_power(state_of(initial));
  initial_elastic_ = initial.accepted.elastic;
  now_ = {};
  now_.initial_kinetic = now_.kinetic =
      system.kinetic_energy(initial.u.data(), initial.v.data()) + initial.accepted.attached_kinetic;
}

void Ledger::exchanged(const StepRecord& record) {
  u_ = record.u;
  external_ = record.external;
  internal_ = record.internal;
}

void Ledger::step(const system::System& system, const StepRecord& record) {
  const system::ViscousLoss power = system.viscous_power(record.v.data());
  const double air_power = system.air_power(record.v.data());
  const double wind_power = system.wind_power(state_of(record));

  now_.external_work += 0.5 * (external_ + record.external).dot(record.u - u_);
  now_.internal_work += 0.5 * (internal_ + record.internal).dot(record.u - u_);
  now_.kinetic = system.kinetic_energy(record.u.data(), record.v.data()) + record.accepted.attached_kinetic;
  now_.elastic = record.accepted.elastic - initial_elastic_;
  now_.friction += record.accepted.friction;
  now_.material += record.accepted.material;
  now_.attached += record.accepted.attached;
  now_.quadrature_error += record.accepted.quadrature_error;
  const double half = 0.5 * record.step;
  now_.viscous =
      system::of_each_term([&](auto term) { return now_.viscous.*term + half * (power_.*term + power.*term); });
  now_.air += half * (air_power_ + air_power);
  now_.wind += half * (wind_power_ + wind_power);

  exchanged(record);
  power_ = power;
  air_power_ = air_power;
  wind_power_ = wind_power;
}

}  // namespace strandyn::observe
