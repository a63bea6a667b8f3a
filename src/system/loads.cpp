#include "chain.hpp"

namespace strandyn::system {

using model::Unknown;

Loads loads_of(const model::Model& model) {
  Loads loads{
      .count = model.loads.size(), .dead = Vector::Zero(static_cast<Eigen::Index>(model.unknowns())), .changing = {}};
  for (std::size_t number = 0; number < model.loads.size(); ++number) {
    const model::Load& load = model.loads[number];
    if (!load.dead || !std::holds_alternative<model::Constant>(load.history) || !load.moment.isZero(0)) {
      loads.changing.push_back(number);
      continue;
    }
    const Eigen::Vector3d force = math::evaluate(load.history, 0) * load.force;
    for (const Unknown unknown : {Unknown::x, Unknown::y, Unknown::z}) {
      const auto i = model.index(load.node, unknown);
      if (i) loads.dead(static_cast<Eigen::Index>(*i)) += force(static_cast<Eigen::Index>(unknown));
    }
  }
  return loads;
}

void System::external_force(At at, const double* u, double* f) const {
  // Loads that were added or taken away since are looked at anew.
  if (chain_->loads.count != model_.loads.size()) chain_->loads = loads_of(model_);
  const auto& [count, dead, changing] = chain_->loads;
  for (std::size_t i = 0; i < unknowns(); ++i) f[i] = at.dead * dead(static_cast<Eigen::Index>(i));
  for (const std::size_t number : changing) {
    const model::Load& load = model_.loads[number];
    const double factor = (load.dead ? at.dead : at.part) * math::evaluate(load.history, at.time, at.drives);
    add_at_node(load.node, factor * load.force, f);
    if (!load.moment.isZero(0)) chain_->add_moment(load.node, factor * load.moment, u, f);
  }
}

void System::subtract_external_tangent(At at, const double* u, Matrix& K) const {
  for (const std::size_t number : chain_->loads.changing) {
    const model::Load& load = model_.loads[number];
    if (load.moment.isZero(0)) continue;
    const double factor = (load.dead ? at.dead : at.part) * math::evaluate(load.history, at.time, at.drives);
    chain_->subtract_moment_tangent(load.node, factor * load.moment, u, K);
  }
}

}  // namespace strandyn::system
