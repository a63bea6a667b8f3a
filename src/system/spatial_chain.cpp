#include "chain.hpp"
#include "strandyn/beam/rigid_inertia.hpp"
#include "strandyn/math/rotation.hpp"

namespace strandyn::system {

using beam::gauss_points;
using beam::SpatialMatrix;
using beam::SpatialVector;
using enum section::Component;

namespace {

/// Rotations are re-based before they come near the turn at which their map is singular.
constexpr double longest_rotation = 4.0;  // [rad] of 2 pi

constexpr std::array components = {axial, torsion, bending2, bending3};

/// B = 6: all unknowns. B = 5: rotation x is left out, it stays zero, and twist gives no strain.
template <int B>
class SpatialChain final : public Chain {
 public:
  explicit SpatialChain(const model::Model& model)
      : consistent_(model.mass_matrix == model::MassMatrix::consistent),
        inertia_(model.inertia),
        elements_(model.elements),
        kinematics_(model.elements.size()),
        at_nodes_(model.nodes.size(), beam::RigidInertia{.mass = 0, .moment = Eigen::Matrix3d::Zero()}) {
    beam::SpatialSectionInertia lumped = model.inertia;
    if (consistent_) lumped.mass = 0;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      const beam::RigidInertia share = beam::nodal_inertia(elements_[e], lumped);
      for (std::size_t node : {e, e + 1}) {
        at_nodes_[node].mass += share.mass;
        at_nodes_[node].moment += share.moment;
      }
    }
    for (const model::Body& body : model.bodies) {
      at_nodes_[body.node].mass += body.mass;
      at_nodes_[body.node].moment += body.inertia * Eigen::Matrix3d::Identity();
    }
  }

  section::Dimension dimension() const override { return section::Dimension::spatial; }

  void find_strains(const double* u, section::Field& strains) override {
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      kinematics_[e] = beam::kinematics(elements_[e], gather(u, e));
      const beam::SpatialKinematics& k = kinematics_[e];
      for (std::size_t g = 0; g < gauss_points; ++g) {
        const std::size_t point = e * gauss_points + g;
        strains[axial][point] = k.eps;
        strains[torsion][point] = twists ? k.chi1 : 0.0;
        strains[bending2][point] = k.chi2[g];
        strains[bending3][point] = k.chi3[g];
      }
    }
  }

  void add_internal_force(const section::Field& stresses, double* f) const override {
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      scatter(beam::internal_force(elements_[e], kinematics_[e], resultants(stresses, e)), e, f);
    }
  }

  void add_stiffness(const section::Field& stresses, const section::TangentField& tangents, Matrix& K) const override {
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      beam::SpatialSectionTangent t;
      for (std::size_t g = 0; g < gauss_points; ++g) {
        const std::size_t point = e * gauss_points + g;
        for (std::size_t r = 0; r < components.size(); ++r) {
          for (std::size_t c = 0; c < components.size(); ++c) {
            const bool counts = twists || (components[r] != torsion && components[c] != torsion);
            t.C[g](static_cast<int>(r), static_cast<int>(c)) =
                counts ? tangents(components[r], components[c])[point] : 0.0;
          }
        }
      }
      add(e, beam::tangent(elements_[e], kinematics_[e], resultants(stresses, e), t), K);
    }
  }

  void add_inertia_force(const State& m, double* f) const override {
    for (std::size_t node = 0; node < at_nodes_.size(); ++node) {
      const beam::RigidInertia& body = at_nodes_[node];
      for (std::size_t i = 0; i < 3; ++i) f[node * B + i] += body.mass * m.a[node * B + i];
      if (!turns(node)) continue;
      add_rotation(beam::rotary_force(body, rotation_motion(m, node)), node, f);
    }
    if (!consistent_) return;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      scatter(beam::consistent_inertia_force(elements_[e], inertia_, motion_of_element(m, e)), e, f);
    }
  }

  void add_inertia_tangent(const State& m, InertiaFactors factors, Matrix& K) const override {
    auto& blocks = K.as<B>();
    for (std::size_t node = 0; node < at_nodes_.size(); ++node) {
      blocks.diagonal(node).diagonal().template head<3>().array() += factors.acceleration * at_nodes_[node].mass;
      if (!turns(node)) continue;
      const auto t = beam::rotary_tangent(at_nodes_[node], rotation_motion(m, node));
      const Eigen::Matrix3d sum =
          factors.acceleration * t.mass + factors.velocity * t.velocity + factors.position * t.position;
      blocks.diagonal(node).template bottomRightCorner<rotations, rotations>() +=
          sum.bottomRightCorner<rotations, rotations>();
    }
    if (!consistent_) return;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      add(e, beam::consistent_inertia_tangent(elements_[e], inertia_, motion_of_element(m, e), factors), K);
    }
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
    if (!consistent_) return sum / 2;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      const SpatialVector rate = gather(v, e);
      sum += rate.dot(beam::consistent_mass(elements_[e], inertia_, gather(u, e)) * rate);
    }
    return sum / 2;
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
  static beam::RotationMotion rotation_motion(const State& m, std::size_t node) {
    return {.psi = rotation(m.u, node), .rate = rotation(m.v, node), .acceleration = rotation(m.a, node)};
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
  static beam::SpatialMotion motion_of_element(const State& m, std::size_t e) {
    return {.q = gather(m.u, e), .v = gather(m.v, e), .a = gather(m.a, e)};
  }
  static void add_rotation(const Eigen::Vector3d& moment, std::size_t node, double* f) {
    for (int i = 0; i < rotations; ++i) f[node * B + 3 + static_cast<std::size_t>(i)] += moment(i + 3 - rotations);
  }
  static void scatter(const SpatialVector& force, std::size_t e, double* f) {
    for (int end = 0; end < 2; ++end) {
      const std::size_t node = e + static_cast<std::size_t>(end);
      for (int i = 0; i < 3; ++i) f[node * B + static_cast<std::size_t>(i)] += force(6 * end + i);
      add_rotation(force.segment<3>(6 * end + 3), node, f);
    }
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
  static beam::SpatialResultants resultants(const section::Field& stresses, std::size_t e) {
    beam::SpatialResultants r;
    for (std::size_t g = 0; g < gauss_points; ++g) {
      const std::size_t point = e * gauss_points + g;
      r.N[g] = stresses[axial][point];
      r.M1[g] = twists ? stresses[torsion][point] : 0.0;
      r.M2[g] = stresses[bending2][point];
      r.M3[g] = stresses[bending3][point];
    }
    return r;
  }
  bool turns(std::size_t node) const { return at_nodes_[node].moment.trace() > 0; }

  bool consistent_;
  beam::SpatialSectionInertia inertia_;
  std::vector<beam::SpatialElement> elements_;
  std::vector<beam::SpatialKinematics> kinematics_;
  std::vector<beam::RigidInertia> at_nodes_;
};

}  // namespace

std::unique_ptr<Chain> make_spatial_chain(const model::Model& model) {
  if (model.freedom == model::Freedom::spatial) return std::make_unique<SpatialChain<6>>(model);
  return std::make_unique<SpatialChain<5>>(model);
}

}  // namespace strandyn::system
