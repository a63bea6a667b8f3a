#include <cmath>

#include "chain.hpp"
#include "strandyn/beam/planar_inertia.hpp"
#include "strandyn/beam/planar_lanes.hpp"

namespace strandyn::system {

using beam::gauss_points;
using beam::PlanarMatrix;
using beam::PlanarVector;
using enum section::Component;

namespace {

constexpr std::size_t B = 3;  // x, y, rotation z

Eigen::Map<const PlanarVector> of_element(const double* all, std::size_t e) {
  return Eigen::Map<const PlanarVector>(all + e * B);
}

Eigen::Map<PlanarVector> of_element(double* all, std::size_t e) {
  return Eigen::Map<PlanarVector>(all + e * B);
}

std::vector<beam::PlanarElement> planar(const std::vector<beam::SpatialElement>& elements) {
  std::vector<beam::PlanarElement> in_plane;
  for (const beam::SpatialElement& element : elements) {
    in_plane.push_back({.span = element.span.head<2>(),
                        .length = element.length,
                        .rest_angle = std::atan2(element.triad(1, 0), element.triad(0, 0))});
  }
  return in_plane;
}

class PlanarChain final : public Chain {
 public:
  explicit PlanarChain(const model::Model& model)
      : consistent_(model.mass_matrix == model::MassMatrix::consistent),
        mass_per_length_{.mass = model.inertia.mass, .rotary = 0},
        lumped_(Vector::Zero(static_cast<Eigen::Index>(model.unknowns()))),
        elements_(planar(model.elements)),
        lanes_(elements_, model.inertia.mass) {
    const beam::Inertia at_nodes{.mass = consistent_ ? 0 : model.inertia.mass, .rotary = model.inertia.rotary};
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      of_element(lumped_.data(), e) += beam::lumped_mass(elements_[e], at_nodes);
    }
    for (const model::Body& body : model.bodies) {
      const auto first = static_cast<Eigen::Index>(body.node * B);
      lumped_.segment<3>(first) += Eigen::Vector3d(body.mass, body.mass, body.inertia);
    }
  }

  section::Dimension dimension() const override { return section::Dimension::planar; }

  void find_strains(const double* u, section::Field& strains) override {
    lanes_.find_strains(u, strains[axial].data(), strains[bending2].data());
  }

  void add_internal_force(const section::Field& stresses, double* f) const override {
    lanes_.add_internal_force(stresses[axial].data(), stresses[bending2].data(), f);
  }

  void add_stiffness(const section::Field& stresses, const section::TangentField& tangents, Matrix& K) const override {
    auto& blocks = K.as<B>();
    lanes_.find_tangents(stresses[axial].data(), stresses[bending2].data(),
                         {.N_eps = tangents(axial, axial).data(),
                          .N_chi = tangents(axial, bending2).data(),
                          .M_eps = tangents(bending2, axial).data(),
                          .M_chi = tangents(bending2, bending2).data()});
    for (std::size_t e = 0; e < elements_.size(); ++e) blocks.add_element(e, lanes_.tangent(e));
  }

  void add_inertia_force(const State& m, double* f) const override {
    for (Eigen::Index i = 0; i < lumped_.size(); ++i) f[i] += lumped_(i) * m.a[i];
    if (consistent_) lanes_.add_inertia_force(m.u, m.v, m.a, f);
  }

  void add_inertia_tangent(const State& m, InertiaFactors factors, Matrix& K) const override {
    auto& blocks = K.as<B>();
    add_diagonal(factors.acceleration, K);
    if (!consistent_) return;
    lanes_.find_inertia_tangents(m.u, m.v, m.a, factors);
    for (std::size_t e = 0; e < elements_.size(); ++e) blocks.add_element(e, lanes_.inertia_tangent(e));
  }

  void add_mass(const double* u, Matrix& M) const override {
    add_diagonal(1, M);
    if (!consistent_) return;
    auto& blocks = M.as<B>();
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      blocks.add_element(e, beam::consistent_mass(elements_[e], mass_per_length_, of_element(u, e)));
    }
  }

  double kinetic_energy(const double* u, const double* v) const override {
    double twice = 0;
    for (Eigen::Index i = 0; i < lumped_.size(); ++i) twice += lumped_(i) * v[i] * v[i];
    double energy = twice / 2;
    if (consistent_) energy += lanes_.kinetic_energy(u, v);
    return energy;
  }

  bool has_mass(std::size_t i) const override { return consistent_ || lumped_(static_cast<Eigen::Index>(i)) > 0; }

  void add_moment(std::size_t node, const Eigen::Vector3d& moment, const double*, double* f) const override {
    f[node * B + 2] += moment.z();
  }

 private:
  void add_diagonal(double factor, Matrix& K) const {
    auto& blocks = K.as<B>();
    for (std::size_t node = 0; node < blocks.nodes(); ++node) {
      blocks.diagonal(node).diagonal() += factor * lumped_.segment<3>(static_cast<Eigen::Index>(node * B));
    }
  }

  bool consistent_;
  beam::Inertia mass_per_length_;  // of the consistent part
  Vector lumped_;                  // [kg], [kg m^2] what sits at the nodes
  std::vector<beam::PlanarElement> elements_;
  mutable beam::PlanarLanes lanes_;  // and what it works in
};

}  // namespace

std::unique_ptr<Chain> make_planar_chain(const model::Model& model) {
  return std::make_unique<PlanarChain>(model);
}

}  // namespace strandyn::system
