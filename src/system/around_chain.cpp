// What is around a chain: still air, wind, and what hangs on it.
#include "strandyn/system/system.hpp"

namespace strandyn::system {

void System::set_swing(double frequency) {
  if (model_.surroundings) air_ = air::force_at(model_.surroundings->air, model_.surroundings->diameter, frequency);
}

double System::air_power(const double* v) const {
  return air_.is_none() ? 0 : air_on_chain_.power(air_, v);
}

void System::add_attached_force(const State& state, double time, double* f) const {
  if (wind_) wind_->subtract_force(state, time, f);
  for (const auto& attachment : attached_) attachment->add_force(state, time, f);
}

double System::wind_power(const State& state) const {
  return wind_ ? wind_->power(state) : 0;
}

Accepted System::commit(const State& state, double time) {
  if (wind_) wind_->commit(state, time);
  Accepted sum = commit(state.u, time);
  for (const auto& attachment : attached_) {
    const AttachedEnergy energy = attachment->commit(state, time);
    sum.elastic += energy.elastic;
    sum.attached_kinetic += energy.kinetic;
    sum.attached += energy.lost;
  }
  return sum;
}

}  // namespace strandyn::system
