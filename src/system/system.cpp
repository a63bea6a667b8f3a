#include "strandyn/system/system.hpp"

#include <algorithm>
#include <iterator>

#include "chain.hpp"
#include "strandyn/core/error.hpp"

namespace strandyn::system {

using beam::gauss_points;
using model::Unknown;

namespace {

std::unique_ptr<Chain> make_chain(const model::Model& model) {
  std::unique_ptr<Chain> chain = model::is_transverse(model.freedom)       ? make_transverse_chain(model)
                                 : model.freedom == model::Freedom::planar ? make_planar_chain(model)
                                                                           : make_spatial_chain(model);
  chain->loads = loads_of(model);
  return chain;
}

}  // namespace

System::System(const model::Model& model)
    : model_(model),
      chain_(make_chain(model)),
      held_(model.unknowns(), false),
      mass_(model.unknowns(), false),
      drag_(Vector::Zero(static_cast<Eigen::Index>(model.unknowns()))),
      air_on_chain_(model),
      eccentric_(model),
      material_(model.material, chain_->dimension(), model.elements.size() * gauss_points),
      energy_(model.elements.size() * gauss_points),
      committed_(chain_->dimension(), model.elements.size() * gauss_points),
      strains_(committed_),
      stresses_(committed_),
      tangents_(chain_->dimension(), model.elements.size() * gauss_points),
      damping_force_(drag_),
      load_(drag_) {
  std::ranges::copy_if(model.bodies, std::back_inserter(sprung_),
                       [](const model::Body& body) { return body.stiffness != 0 || body.damping != 0; });
  const auto unknowns_of_node = model::unknowns_of(model.freedom);
  for (const model::Support& support : model.supports) {
    for (std::size_t i = 0; i < unknowns_of_node.size(); ++i) {
      if (support.fixed[static_cast<std::size_t>(unknowns_of_node[i])]) {
        held_[support.node * unknowns_of_node.size() + i] = true;
      }
    }
  }
  for (const model::PrescribedMotion& motion : model.motions) {
    const auto i = model.index(motion.node, motion.unknown);
    if (!i) throw ComputationError("a motion was prescribed to an unknown that the chain does not have");
    moved_.push_back(*i);
    held_[*i] = true;
  }
  for (std::size_t e = 0; e < model.elements.size(); ++e) {
    const double share = model.drag * model.elements[e].length / 2;
    for (std::size_t node : {e, e + 1}) {
      for (Unknown unknown : {Unknown::x, Unknown::y, Unknown::z}) {
        if (const auto i = model.index(node, unknown)) drag_(static_cast<Eigen::Index>(*i)) += share;
      }
    }
  }
  for (std::size_t i = 0; i < unknowns(); ++i) mass_[i] = !held_[i] && chain_->has_mass(i);
}

System::~System() = default;

void System::held_values(At at, double* u) const {
  for (std::size_t i = 0; i < unknowns(); ++i) {
    if (held_[i]) u[i] = 0;
  }
  for (std::size_t m = 0; m < moved_.size(); ++m) {
    u[moved_[m]] += at.part * model_.motions[m].at(at.time, at.drives);
  }
}

void System::held_rates(At at, double* v) const {
  for (std::size_t i = 0; i < unknowns(); ++i) {
    if (held_[i]) v[i] = 0;
  }
  for (std::size_t m = 0; m < moved_.size(); ++m) {
    v[moved_[m]] += model_.motions[m].rate(at.time, at.drives);
  }
}

void System::begin(const ConstVectorRef& u) {
  chain_->find_strains(u.data(), strains_);
  history_ = model_.law->start(strains_);
  material_.relax();
  clock_.reset();
  stored_at_begin_.assign(strains_.points(), 0);
  commit(u.data());
  stored_at_begin_ = energy_.stored;
}

void System::find_stresses(const double* u, std::optional<double> time, section::TangentField* tangents) const {
  {
    const Stopwatch::Lap lap(stopwatch_, Part::element);
    chain_->find_strains(u, strains_);
  }
  const Stopwatch::Lap lap(stopwatch_, Part::section);
  effort_ += model_.law->respond(history_, strains_, stresses_, tangents);
  if (!material_.is_empty() && clock_ && time) {
    material_.respond(committed_, strains_, *time - *clock_, stresses_, tangents);
  }
}

void System::internal_force_at(const double* u, std::optional<double> time, double* f) const {
  ++residual_evaluations_;
  std::fill(f, f + unknowns(), 0.0);
  find_stresses(u, time, nullptr);
  const Stopwatch::Lap lap(stopwatch_, Part::element);
  chain_->add_internal_force(stresses_, f);
  add_springs(u, f);
}

void System::internal_force_at(const double* u, std::optional<double> time, double* f, Matrix& K) const {
  ++jacobian_evaluations_;
  std::fill(f, f + unknowns(), 0.0);
  find_stresses(u, time, &tangents_);
  const Stopwatch::Lap lap(stopwatch_, Part::element);
  K.set_zero();
  chain_->add_internal_force(stresses_, f);
  chain_->add_stiffness(stresses_, tangents_, K);
  add_springs(u, f);
  for (const model::Body& body : sprung_) add_along(body, body.stiffness, K);
}

void System::internal_force(const double* u, double* f) const {
  internal_force_at(u, {}, f);
}

void System::internal_force(const double* u, double* f, Matrix& K) const {
  internal_force_at(u, {}, f, K);
}

void System::residual(const State& state, At at, double* r) const {
  internal_force_at(state.u, at.time, r);
  if (!state.is_at_rest()) add_inertia_and_drag(state, r);
  if (!state.is_at_rest()) add_attached_force(state, at.time, r);
  external_force(at, state.u, load_.data());
  for (std::size_t i = 0; i < unknowns(); ++i) r[i] -= load_(static_cast<Eigen::Index>(i));
}

void System::residual(const State& state, At at, double* r, Matrix& K) const {
  internal_force_at(state.u, at.time, r, K);
  subtract_external_tangent(at, state.u, K);
  if (!state.is_at_rest()) add_inertia_and_drag(state, r);
  if (!state.is_at_rest()) add_attached_force(state, at.time, r);
  external_force(at, state.u, load_.data());
  for (std::size_t i = 0; i < unknowns(); ++i) r[i] -= load_(static_cast<Eigen::Index>(i));
}

void System::reactions(const State& state, At at, double* f) const {
  residual(state, at, f);
  for (std::size_t i = 0; i < unknowns(); ++i) {
    if (!held_[i]) f[i] = 0;
  }
}

void System::forces(const State& state, At at, Vector& external, Vector& internal) const {
  external_force(at, state.u, external.data());
  internal_force_at(state.u, at.time, internal.data());
  if (!has_moving_supports()) return;
  load_ = internal;
  if (!state.is_at_rest()) add_inertia_and_drag(state, load_.data());
  if (!state.is_at_rest()) add_attached_force(state, at.time, load_.data());
  for (std::size_t i = 0; i < unknowns(); ++i) {
    if (held_[i]) external(static_cast<Eigen::Index>(i)) = load_(static_cast<Eigen::Index>(i));
  }
}

void System::strains(const double* u, section::Field& strains) const {
  const Stopwatch::Lap lap(stopwatch_, Part::element);
  chain_->find_strains(u, strains);
}

void System::internal_force_of(const section::Field& stresses, const double* u, double* f) const {
  const Stopwatch::Lap lap(stopwatch_, Part::element);
  std::fill(f, f + unknowns(), 0.0);
  chain_->find_strains(u, strains_);
  chain_->add_internal_force(stresses, f);
  add_springs(u, f);
}

void System::stiffness_of(const section::Field& stresses, const section::TangentField& tangents, const double* u,
                          Matrix& K) const {
  const Stopwatch::Lap lap(stopwatch_, Part::element);
  chain_->find_strains(u, strains_);
  K.set_zero();
  chain_->add_stiffness(stresses, tangents, K);
  for (const model::Body& body : sprung_) add_along(body, body.stiffness, K);
}

void System::add_springs(const double* u, double* f) const {
  for (const model::Body& body : sprung_) {
    const double stretch = body.direction.dot(model_.displacement(u, body.node));
    add_at_node(body.node, body.stiffness * stretch * body.direction, f);
  }
}

void System::add_at_node(std::size_t node, const Eigen::Vector3d& force, double* f) const {
  for (Unknown unknown : {Unknown::x, Unknown::y, Unknown::z}) {
    if (const auto i = model_.index(node, unknown)) f[*i] += force(static_cast<Eigen::Index>(unknown));
  }
}

void System::add_along(const model::Body& body, double factor, Matrix& K) const {
  if (factor == 0) return;
  for (Unknown row : {Unknown::x, Unknown::y, Unknown::z}) {
    for (Unknown column : {Unknown::x, Unknown::y, Unknown::z}) {
      const auto i = model_.index(body.node, row);
      const auto j = model_.index(body.node, column);
      if (!i || !j) continue;
      const double product =
          body.direction(static_cast<Eigen::Index>(row)) * body.direction(static_cast<Eigen::Index>(column));
      K.add_at_node(*i, *j, factor * product);
    }
  }
}

void System::add_inertia_and_drag(const State& m, double* f) const {
  const Stopwatch::Lap lap(stopwatch_, Part::inertia);
  chain_->add_inertia_force(m, f);
  eccentric_.add_inertia_force(m.u, m.v, m.a, f);
  if (model_.drag > 0) {
    for (std::size_t i = 0; i < unknowns(); ++i) f[i] += drag_(static_cast<Eigen::Index>(i)) * m.v[i];
  }
  if (!air_.is_none()) air_on_chain_.add_force(air_, m.v, f);
  for (const model::Body& body : sprung_) {
    const double rate = body.direction.dot(model_.displacement(m.v, body.node));
    add_at_node(body.node, body.damping * rate * body.direction, f);
  }
  const auto n = static_cast<Eigen::Index>(unknowns());
  if (damping_.rayleigh) {
    damping_.rayleigh->multiply(m.v, damping_force_.data());
    Eigen::Map<Vector>(f, n) += damping_force_;
  }
  for (const ProportionalDamping::Mode& mode : damping_.modes) {
    Eigen::Map<Vector>(f, n) += mode.factor * mode.momentum.dot(Eigen::Map<const Vector>(m.v, n)) * mode.momentum;
  }
}

void System::add_inertia_and_drag(const State& m, InertiaFactors factors, Matrix& K) const {
  const Stopwatch::Lap lap(stopwatch_, Part::inertia);
  chain_->add_inertia_tangent(m, factors, K);
  eccentric_.add_inertia_tangent(m.u, m.v, m.a, factors, K);
  if (model_.drag > 0 && factors.velocity != 0) {
    for (std::size_t i = 0; i < unknowns(); ++i) {
      K.add_at_node(i, i, factors.velocity * drag_(static_cast<Eigen::Index>(i)));
    }
  }
  if (!air_.is_none() && factors.velocity != 0) air_on_chain_.add_tangent(air_, m.v, factors.velocity, K);
  for (const model::Body& body : sprung_) add_along(body, factors.velocity * body.damping, K);
  if (damping_.rayleigh && factors.velocity != 0) K.add(factors.velocity, *damping_.rayleigh);
  if (wind_ && factors.velocity != 0) wind_->subtract_tangent(factors.velocity, K);
  if (factors.position == 0) return;  // part of a step's matrix, or none of it
  for (const auto& attachment : attached_) attachment->add_tangent(K);
}

void System::hold(Matrix& K) const {
  for (std::size_t i = 0; i < unknowns(); ++i) {
    if (held_[i]) K.pin_row(i);
  }
}

void System::mass_matrix(const double* u, Matrix& M) const {
  M.set_zero();
  chain_->add_mass(u, M);
  eccentric_.add_mass(u, M);
}

double System::kinetic_energy(const double* u, const double* v) const {
  return chain_->kinetic_energy(u, v) + eccentric_.kinetic_energy(u, v);
}

ViscousLoss System::viscous_power(const double* v) const {
  ViscousLoss power;
  if (model_.drag > 0) {
    for (std::size_t i = 0; i < unknowns(); ++i) power.drag += drag_(static_cast<Eigen::Index>(i)) * v[i] * v[i];
  }
  for (const model::Body& body : sprung_) {
    const double rate = body.direction.dot(model_.displacement(v, body.node));
    power.dampers += body.damping * rate * rate;
  }
  const Eigen::Map<const Vector> rates(v, static_cast<Eigen::Index>(unknowns()));
  if (damping_.rayleigh) {
    damping_.rayleigh->multiply(v, damping_force_.data());
    power.rayleigh = rates.dot(damping_force_);
  }
  for (const ProportionalDamping::Mode& mode : damping_.modes) {
    const double rate = mode.momentum.dot(rates);
    power.modal += mode.factor * rate * rate;
  }
  return power;
}

void System::accelerations(const double* u, const double* v, const double* force, double* a) const {
  const Vector zero = make_vector();
  Vector velocity_terms = zero;
  const State without_acceleration{.u = u, .v = v, .a = zero.data()};
  add_inertia_and_drag(without_acceleration, velocity_terms.data());
  add_attached_force(without_acceleration, clock_.value_or(0), velocity_terms.data());
  Matrix M = make_matrix();
  mass_matrix(u, M);
  for (std::size_t i = 0; i < unknowns(); ++i) {
    if (!mass_[i]) M.pin(i);
    a[i] = mass_[i] ? force[i] - velocity_terms(static_cast<Eigen::Index>(i)) : 0.0;
  }
  math::ChainFactors factors;
  if (!factors.factorize(M)) throw ComputationError("the mass matrix is singular: an unknown is without inertia");
  factors.solve(a);
}

Accepted System::commit(const double* u) {
  return commit(u, clock_.value_or(0));
}

Accepted System::commit(const double* u, double time) {
  chain_->find_strains(u, strains_);
  const Stopwatch::Lap lap(stopwatch_, Part::commit);
  effort_ += model_.law->commit(history_, strains_, energy_);
  if (clock_) {
    material_.commit(committed_, strains_, time - *clock_);
    clock_ = time;
  }
  committed_ = strains_;
  Accepted sum{.elastic = elastic_energy(energy_.stored, u)};
  for (std::size_t point = 0; point < committed_.points(); ++point) {
    const double length = point_length(point);
    sum.friction += length * energy_.dissipated[point];
    sum.quadrature_error += length * energy_.quadrature_error[point];
    if (material_.is_empty()) continue;
    sum.material += length * material_.dissipated()[point];
    sum.quadrature_error += length * material_.quadrature_error()[point];
  }
  return sum;
}

double System::elastic_energy(const AlignedVector& stored, const double* u) const {
  double energy = 0;
  for (std::size_t point = 0; point < strains_.points(); ++point) {  // the rows are longer: whole registers
    energy += point_length(point) * (stored[point] - stored_at_begin_[point]);
    if (!material_.is_empty()) energy += point_length(point) * material_.stored()[point];
  }
  for (const model::Body& body : sprung_) {
    const double stretch = body.direction.dot(model_.displacement(u, body.node));
    energy += body.stiffness * stretch * stretch / 2;
  }
  return energy;
}

void System::archive(Archive& a) {
  a.grown(history_.data);  // some laws remember as many reversals as there have been
  a(energy_.stored, energy_.dissipated, energy_.quadrature_error);
  for (std::size_t c = 0; c < section::component_count; ++c) a(committed_[section::Component{c}]);
  a(material_, clock_, effort_, residual_evaluations_, jacobian_evaluations_);
  if (wind_) wind_->archive(a);
  for (const auto& attachment : attached_) attachment->archive(a);
}

bool System::shorten_rotations(double* u, double* v) const {
  return chain_->shorten_rotations(held_, u, v);
}

}  // namespace strandyn::system
