#include <algorithm>

#include "chain.hpp"
#include "strandyn/beam/rigid_inertia.hpp"
#include "strandyn/beam/spatial_lanes.hpp"
#include "strandyn/math/rotation.hpp"

namespace strandyn::system {

using beam::SpatialLanes;
using beam::SpatialMatrix;
using beam::SpatialVector;
using enum section::Component;

namespace {

/// Rotations are re-based before they come near the turn at which their map is singular.
constexpr double longest_rotation = 4.0;  // [rad] of 2 pi

/// What turns with each node: half of the sections beside it, and bodies.
std::vector<beam::RigidInertia> lumped(const model::Model& model) {
  std::vector<beam::RigidInertia> at_nodes(model.nodes.size());
  beam::SpatialSectionInertia of_sections = model.inertia;
  if (model.mass_matrix == model::MassMatrix::consistent) of_sections.mass = 0;
  for (std::size_t e = 0; e < model.elements.size(); ++e) {
    const beam::RigidInertia share = beam::nodal_inertia(model.elements[e], of_sections);
    for (std::size_t node : {e, e + 1}) {
      at_nodes[node].mass += share.mass;
      at_nodes[node].moment += share.moment;
    }
  }
  for (const model::Body& body : model.bodies) {
    at_nodes[body.node].mass += body.mass;
    at_nodes[body.node].moment += body.inertia * Eigen::Matrix3d::Identity();
  }
  return at_nodes;
}

SpatialLanes::Points rows_of(const section::Field& field) {
  return {field[axial].data(), field[torsion].data(), field[bending2].data(), field[bending3].data()};
}

SpatialLanes::Points rows_of(const section::TangentField& tangents, section::Component resultant) {
  return {tangents(resultant, axial).data(), tangents(resultant, torsion).data(), tangents(resultant, bending2).data(),
          tangents(resultant, bending3).data()};
}

/// B = 6: all unknowns. B = 5: rotation x is left out, it stays zero, and twist gives no strain.
template <int B>
class SpatialChain final : public Chain {
 public:
  explicit SpatialChain(const model::Model& model)
      : consistent_(model.mass_matrix == model::MassMatrix::consistent),
        inertia_(model.inertia),
        elements_(model.elements),
        at_nodes_(lumped(model)),
        any_turns_(std::ranges::any_of(at_nodes_, [](const auto& body) { return body.moment.trace() > 0; })),
        lanes_({.elements = elements_,
                .inertia = inertia_,
                .at_nodes = at_nodes_,
                .unknowns = twists ? SpatialLanes::Unknowns::all : SpatialLanes::Unknowns::untwisted}) {}

  section::Dimension dimension() const override { return section::Dimension::spatial; }

  void find_strains(const double* u, section::Field& strains) override {
    lanes_.find_strains(
        u, {strains[axial].data(), strains[torsion].data(), strains[bending2].data(), strains[bending3].data()});
  }

  void add_internal_force(const section::Field& stresses, double* f) const override {
    lanes_.add_internal_force(rows_of(stresses), f);
  }

  void add_stiffness(const section::Field& stresses, const section::TangentField& tangents, Matrix& K) const override {
    lanes_.add_stiffness(rows_of(stresses),
                         {rows_of(tangents, axial), rows_of(tangents, torsion), rows_of(tangents, bending2),
                          rows_of(tangents, bending3)},
                         blocks_of(K));
  }

  void add_inertia_force(const State& m, double* f) const override {
    for (std::size_t node = 0; node < at_nodes_.size(); ++node) {
      const double mass = at_nodes_[node].mass;
      for (std::size_t i = node * B; i < node * B + 3; ++i) f[i] += mass * m.a[i];
    }
    if (any_turns_) lanes_.add_rotary_force(m.u, m.v, m.a, f);
    if (consistent_) lanes_.add_inertia_force(m.u, m.v, m.a, f);
  }

  void add_inertia_tangent(const State& m, InertiaFactors factors, Matrix& K) const override {
    auto& blocks = K.as<B>();
    for (std::size_t node = 0; node < at_nodes_.size(); ++node) {
      blocks.diagonal(node).diagonal().template head<3>().array() += factors.acceleration * at_nodes_[node].mass;
    }
    if (any_turns_) lanes_.add_rotary_tangent(m.u, m.v, m.a, factors, blocks_of(K));
    if (consistent_) lanes_.add_inertia_tangent(m.u, m.v, m.a, factors, blocks_of(K));
  }

  void add_mass(const double* u, Matrix& M) const override {
    auto& blocks = M.as<B>();
    for (std::size_t node = 0; node < at_nodes_.size(); ++node) {
      blocks.diagonal(node).diagonal().template head<3>().array() += at_nodes_[node].mass;
      if (!turns(node)) continue;
      blocks.diagonal(node).template bottomRightCorner<rotations, rotations>() +=
          beam::rotary_mass(at_nodes_[node], rotation(u, node)).template bottomRightCorner<rotations, rotations>();
    }
    if (!consistent_) return;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      add(e, beam::consistent_mass(elements_[e], inertia_, gather(u, e)), M);
    }
  }

  double kinetic_energy(const double* u, const double* v) const override {
    double sum = 0;
    for (std::size_t node = 0; node < at_nodes_.size(); ++node) {
      for (std::size_t i = 0; i < 3; ++i) sum += at_nodes_[node].mass * v[node * B + i] * v[node * B + i];
      if (!turns(node)) continue;
      const Eigen::Vector3d rate = rotation(v, node);
      sum += rate.dot(beam::rotary_mass(at_nodes_[node], rotation(u, node)) * rate);
    }
    return sum / 2 + (consistent_ ? lanes_.kinetic_energy(u, v) : 0.0);
  }

  bool has_mass(std::size_t i) const override {
    const std::size_t node = i / B;
    if (consistent_) return true;
    if (i % B < 3) return at_nodes_[node].mass > 0;
    const auto axis = static_cast<int>(i % B) - B + 3;
    return at_nodes_[node].moment(axis, axis) > 0;
  }

  /// Work-conjugate to the change of the rotation vector: the spin map brings the moment there.
  void add_moment(std::size_t node, const Eigen::Vector3d& moment, const double* u, double* f) const override {
    add_rotation(math::spin_map(rotation(u, node)).transpose() * moment, node, f);
  }

  void subtract_moment_tangent(std::size_t node, const Eigen::Vector3d& moment, const double* u,
                               Matrix& K) const override {
    K.as<B>().diagonal(node).template bottomRightCorner<rotations, rotations>() -=
        math::spin_map_transposed_slope(rotation(u, node), moment).template bottomRightCorner<rotations, rotations>();
  }

  bool shorten_rotations(const std::vector<bool>& held, double* u, double* v) const override {
    if constexpr (!twists) return false;
    bool any = false;
    for (std::size_t node = 0; node < at_nodes_.size(); ++node) {
      const Eigen::Vector3d psi = rotation(u, node);
      const bool free = !held[node * B + 3] && !held[node * B + 4] && !held[node * B + 5];
      if (!free || psi.norm() < longest_rotation) continue;
      const math::RotationState shorter = math::shortened({.psi = psi, .rate = rotation(v, node)});
      for (int i = 0; i < 3; ++i) {
        u[node * B + 3 + static_cast<std::size_t>(i)] = shorter.psi(i);
        v[node * B + 3 + static_cast<std::size_t>(i)] = shorter.rate(i);
      }
      any = true;
    }
    return any;
  }

 private:
  static constexpr bool twists = B == 6;
  static constexpr int rotations = B - 3;

  static Eigen::Vector3d rotation(const double* all, std::size_t node) {
    const double* last = all + node * B + B;
    return {twists ? last[-3] : 0.0, last[-2], last[-1]};
  }
  static SpatialVector gather(const double* all, std::size_t e) {
    if constexpr (twists) {
      return Eigen::Map<const SpatialVector>(all + e * B);
    } else {
      SpatialVector q;
      for (int end = 0; end < 2; ++end) {
        const double* node = all + (e + static_cast<std::size_t>(end)) * B;
        q.segment<6>(6 * end) << node[0], node[1], node[2], 0, node[3], node[4];
      }
      return q;
    }
  }
  static void add_rotation(const Eigen::Vector3d& moment, std::size_t node, double* f) {
    for (int i = 0; i < rotations; ++i) f[node * B + 3 + static_cast<std::size_t>(i)] += moment(i + 3 - rotations);
  }
  static void add(std::size_t e, const SpatialMatrix& k, Matrix& K) {
    auto& blocks = K.as<B>();
    if constexpr (twists) {
      blocks.add_element(e, k);
    } else {
      constexpr std::array kept = {0, 1, 2, 4, 5, 6, 7, 8, 10, 11};
      blocks.add_element(e, Eigen::Matrix<double, 2 * B, 2 * B>(k(kept, kept)));
    }
  }
  /// The blocks of a kind follow each other without gaps.
  static SpatialLanes::Blocks blocks_of(Matrix& K) {
    auto& blocks = K.as<B>();
    static_assert(sizeof(typename math::BlockTridiagonal<B>::Block) == sizeof(double) * B * B);
    return {blocks.diagonal(0).data(), blocks.upper(0).data(), blocks.lower(0).data(), B};
  }
  bool turns(std::size_t node) const { return at_nodes_[node].moment.trace() > 0; }

  bool consistent_;
  beam::SpatialSectionInertia inertia_;
  std::vector<beam::SpatialElement> elements_;
  std::vector<beam::RigidInertia> at_nodes_;
  bool any_turns_;
  mutable SpatialLanes lanes_;  // and what it works in
};

}  // namespace

std::unique_ptr<Chain> make_spatial_chain(const model::Model& model) {
  if (model.freedom == model::Freedom::spatial) return std::make_unique<SpatialChain<6>>(model);
  return std::make_unique<SpatialChain<5>>(model);
}

}  // namespace strandyn::system
