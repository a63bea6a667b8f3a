#include "strandyn/system/system.hpp"

#include <algorithm>

namespace strandyn::system {

using section::Dimension;
using enum section::Component;
using beam::gauss_points;
using beam::PlanarMatrix;
using beam::PlanarVector;
using model::unknowns_per_node;

namespace {

/// The six unknowns of element e, which joins nodes e and e + 1.
Eigen::Map<const PlanarVector> of_element(const double* all, std::size_t e) {
  return Eigen::Map<const PlanarVector>(all + e * unknowns_per_node);
}

Eigen::Map<PlanarVector> of_element(double* all, std::size_t e) {
  return Eigen::Map<PlanarVector>(all + e * unknowns_per_node);
}

beam::PlanarMotion motion_of_element(const Motion& m, std::size_t e) {
  return {.q = of_element(m.u, e), .v = of_element(m.v, e), .a = of_element(m.a, e)};
}

}  // namespace

System::System(const model::Model& model)
    : model_(model),
      held_(model.unknowns(), false),
      mass_(model.unknowns(), true),
      lumped_(Vector::Zero(static_cast<Eigen::Index>(model.unknowns()))),
      drag_(lumped_),
      energy_(model.elements.size() * gauss_points),
      committed_(Dimension::planar, model.elements.size() * gauss_points),
      kinematics_(model.elements.size()),
      strains_(committed_),
      stresses_(committed_),
      tangents_(Dimension::planar, model.elements.size() * gauss_points) {
  for (const model::Support& support : model.supports) {
    for (std::size_t i = 0; i < unknowns_per_node; ++i) {
      if (support.fixed[i]) held_[support.node * unknowns_per_node + i] = true;
    }
  }
  for (std::size_t e = 0; e < model.elements.size(); ++e) {
    of_element(lumped_.data(), e) += beam::lumped_mass(model.elements[e], model.inertia);
    for (std::size_t end : {e, e + 1}) {
      const double share = model.drag * model.elements[e].length / 2;
      for (std::size_t i = 0; i < 2; ++i) drag_(static_cast<Eigen::Index>(end * unknowns_per_node + i)) += share;
    }
  }
  const bool consistent = model.mass_matrix == model::MassMatrix::consistent;
  for (std::size_t i = 0; i < unknowns(); ++i) {
    mass_[i] = !held_[i] && (consistent || lumped_(static_cast<Eigen::Index>(i)) > 0);
  }
}

void System::begin(const ConstVectorRef& u) {
  find_strains(u.data());
  history_ = model_.law->start(strains_);
  commit(u.data());
}

void System::find_strains(const double* u) const {
  const Stopwatch::Lap lap(stopwatch_, Part::element);
  for (std::size_t e = 0; e < model_.elements.size(); ++e) {
    kinematics_[e] = beam::kinematics(model_.elements[e], of_element(u, e));
    for (std::size_t g = 0; g < gauss_points; ++g) {
      strains_[axial][e * gauss_points + g] = kinematics_[e].eps;
      strains_[bending2][e * gauss_points + g] = kinematics_[e].chi[g];
    }
  }
}

void System::assemble(double* f, Matrix* K) const {
  const Stopwatch::Lap lap(stopwatch_, Part::element);
  std::fill(f, f + unknowns(), 0.0);
  if (K) K->set_zero();
  for (std::size_t e = 0; e < model_.elements.size(); ++e) {
    beam::PlanarResultants r;
    for (std::size_t g = 0; g < gauss_points; ++g) {
      r.N[g] = stresses_[axial][e * gauss_points + g];
      r.M[g] = stresses_[bending2][e * gauss_points + g];
    }
    of_element(f, e) += beam::internal_force(model_.elements[e], kinematics_[e], r);
    if (!K) continue;
    beam::PlanarSectionTangent t;
    for (std::size_t g = 0; g < gauss_points; ++g) {
      const std::size_t point = e * gauss_points + g;
      t.N_eps[g] = tangents_(axial, axial)[point];
      t.N_chi[g] = tangents_(axial, bending2)[point];
      t.M_eps[g] = tangents_(bending2, axial)[point];
      t.M_chi[g] = tangents_(bending2, bending2)[point];
    }
    K->add_element(e, beam::tangent(model_.elements[e], kinematics_[e], r, t));
  }
}

void System::internal_force(const double* u, double* f) const {
  ++residual_evaluations_;
  find_strains(u);
  {
    const Stopwatch::Lap lap(stopwatch_, Part::section);
    effort_ += model_.law->respond(history_, strains_, stresses_, nullptr);
  }
  assemble(f, nullptr);
}

void System::internal_force(const double* u, double* f, Matrix& K) const {
  ++jacobian_evaluations_;
  find_strains(u);
  {
    const Stopwatch::Lap lap(stopwatch_, Part::section);
    effort_ += model_.law->respond(history_, strains_, stresses_, &tangents_);
  }
  assemble(f, &K);
}

void System::external_force(double t, double* f) const {
  std::fill(f, f + unknowns(), 0.0);
  for (const model::Load& load : model_.loads) {
    const double factor = model::evaluate(load.history, t);
    for (std::size_t i = 0; i < unknowns_per_node; ++i) {
      f[load.node * unknowns_per_node + i] += factor * load.amplitude(static_cast<Eigen::Index>(i));
    }
  }
}

void System::add_inertia_and_drag(const Motion& m, double* f) const {
  const Stopwatch::Lap lap(stopwatch_, Part::inertia);
  if (model_.mass_matrix == model::MassMatrix::lumped) {
    for (std::size_t i = 0; i < unknowns(); ++i) f[i] += lumped_(static_cast<Eigen::Index>(i)) * m.a[i];
  } else {
    for (std::size_t e = 0; e < model_.elements.size(); ++e) {
      of_element(f, e) += beam::consistent_inertia_force(model_.elements[e], model_.inertia, motion_of_element(m, e));
    }
  }
  if (model_.drag > 0) {
    for (std::size_t i = 0; i < unknowns(); ++i) f[i] += drag_(static_cast<Eigen::Index>(i)) * m.v[i];
  }
}

void System::add_inertia_and_drag(const Motion& m, InertiaFactors factors, Matrix& K) const {
  const Stopwatch::Lap lap(stopwatch_, Part::inertia);
  const bool consistent = model_.mass_matrix == model::MassMatrix::consistent;
  for (std::size_t node = 0; node < model_.nodes.size(); ++node) {
    for (std::size_t i = 0; i < unknowns_per_node; ++i) {
      const auto at = static_cast<Eigen::Index>(node * unknowns_per_node + i);
      const auto row = static_cast<Eigen::Index>(i);
      K.diagonal(node)(row, row) +=
          factors.velocity * drag_(at) + (consistent ? 0.0 : factors.acceleration * lumped_(at));
    }
  }
  if (!consistent) return;
  for (std::size_t e = 0; e < model_.elements.size(); ++e) {
    const auto t = beam::consistent_inertia_tangent(model_.elements[e], model_.inertia, motion_of_element(m, e));
    const PlanarMatrix sum =
        factors.acceleration * t.mass + factors.velocity * t.velocity + factors.position * t.position;
    K.add_element(e, sum);
  }
}

void System::hold(Matrix& K) const {
  for (std::size_t i = 0; i < unknowns(); ++i) {
    if (held_[i]) K.pin(i / unknowns_per_node, static_cast<int>(i % unknowns_per_node));
  }
}

void System::mass_matrix(const double* u, Matrix& M) const {
  M.set_zero();
  for (std::size_t e = 0; e < model_.elements.size(); ++e) {
    if (model_.mass_matrix == model::MassMatrix::lumped) {
      const PlanarMatrix m = beam::lumped_mass(model_.elements[e], model_.inertia).asDiagonal();
      M.add_element(e, m);
    } else {
      M.add_element(e, beam::consistent_mass(model_.elements[e], model_.inertia, of_element(u, e)));
    }
  }
}

double System::kinetic_energy(const double* u, const double* v) const {
  double sum = 0;
  if (model_.mass_matrix == model::MassMatrix::lumped) {
    for (std::size_t i = 0; i < unknowns(); ++i) sum += lumped_(static_cast<Eigen::Index>(i)) * v[i] * v[i];
    return sum / 2;
  }
  for (std::size_t e = 0; e < model_.elements.size(); ++e) {
    const PlanarVector rate = of_element(v, e);
    sum += rate.dot(beam::consistent_mass(model_.elements[e], model_.inertia, of_element(u, e)) * rate);
  }
  return sum / 2;
}

double System::drag_power(const double* v) const {
  double sum = 0;
  for (std::size_t i = 0; i < unknowns(); ++i) sum += drag_(static_cast<Eigen::Index>(i)) * v[i] * v[i];
  return sum;
}

void System::accelerations(const double* u, const double* v, const double* force, double* a) const {
  if (model_.mass_matrix == model::MassMatrix::lumped) {
    for (std::size_t i = 0; i < unknowns(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      a[i] = mass_[i] ? (force[i] - drag_(at) * v[i]) / lumped_(at) : 0.0;
    }
    return;
  }
  const Vector zero = Vector::Zero(static_cast<Eigen::Index>(unknowns()));
  Vector velocity_terms = zero;
  add_inertia_and_drag({.u = u, .v = v, .a = zero.data()}, velocity_terms.data());
  Matrix M(model_.nodes.size());
  mass_matrix(u, M);
  hold(M);
  for (std::size_t i = 0; i < unknowns(); ++i) {
    a[i] = held_[i] ? 0.0 : force[i] - velocity_terms(static_cast<Eigen::Index>(i));
  }
  math::BlockTridiagonalLU<static_cast<int>(unknowns_per_node)> factors;
  factors.factorize(M);
  factors.solve(a);
}

Accepted System::commit(const double* u) {
  find_strains(u);
  const Stopwatch::Lap lap(stopwatch_, Part::commit);
  effort_ += model_.law->commit(history_, strains_, energy_);
  committed_ = strains_;
  Accepted sum;
  for (std::size_t point = 0; point < committed_.points(); ++point) {
    const double length = point_length(point);
    sum.elastic += length * energy_.stored[point];
    sum.friction += length * energy_.dissipated[point];
    sum.quadrature_error += length * energy_.quadrature_error[point];
  }
  return sum;
}

}  // namespace strandyn::system
