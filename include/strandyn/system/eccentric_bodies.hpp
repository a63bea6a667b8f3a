#pragma once
/// \file Bodies whose centre of mass lies beside the node that carries them, as the weight of a Stockbridge damper
/// does.
///
/// With c = R(theta) r from the node to the centre of mass and k the axis out of the plane, the centre moves with
///     v_c = v + theta' k x c,    a_c = a + theta'' k x c - theta'^2 c
/// The node's own lumped mass stands for m v^2/2 and J theta'^2/2, J about the centre of mass. What is left is
///     T = m theta' (v_y c_x - v_x c_y) + m r^2 theta'^2/2
///     f = m (theta'' k x c - theta'^2 c),    moment = m (c_x a_y - c_y a_x + r^2 theta'')
/// exact for rotations of any size in a planar chain. A transverse chain knows no displacement along the span and takes
/// rotations for small: there c = r, and theta'^2 is dropped. Gravity does not act on c: a static moment of the weight
/// is not part of this.

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "strandyn/beam/rigid_inertia.hpp"
#include "strandyn/math/chain_matrix.hpp"
#include "strandyn/model/model.hpp"

namespace strandyn::system {

class EccentricBodies {
 public:
  /// Throws std::invalid_argument where a chain that moves in space has such a body.
  explicit EccentricBodies(const model::Model& model);

  /// Positions, velocities and accelerations of all unknowns of the chain; f [N], [N m] is added to.
  void add_inertia_force(const double* u, const double* v, const double* a, double* f) const;
  /// K += the derivatives of that force by acceleration, velocity and position, each times its factor.
  void add_inertia_tangent(const double* u, const double* v, const double* a, beam::InertiaFactors factors,
                           math::ChainMatrix& K) const;
  void add_mass(const double* u, math::ChainMatrix& M) const;
  double kinetic_energy(const double* u, const double* v) const;  ///< [J]

 private:
  struct Body {
    std::optional<std::size_t> x;  // unknowns
    std::size_t y = 0, turn = 0;
    double mass = 0;    // [kg]
    Eigen::Vector2d r;  // [m]

    bool is_small() const { return !x; }  // are the rotations?
    Eigen::Vector2d arm(const double* u) const { return is_small() ? r : Eigen::Rotation2Dd(u[turn]) * r; }
  };
  std::vector<Body> bodies_;
};

}  // namespace strandyn::system
