#pragma once
/// \file A frame that turns with its total rotation vector psi, its spin seen from the frame, and their derivatives.
///
///     R = Exp(psi),   S = T(psi)^T = T(-psi),   R dTheta~ = dR with dTheta = S dpsi
///     W = S psi',     A = W' = S psi'' + S' psi'
/// Spins commute with time up to a cross product, dW = dTheta' + W x dTheta. So first derivatives of W and A need no
/// more than time derivatives of S:
///     dW = S dpsi' + (S' + W~ S) dpsi
///     dA = S dpsi'' + (2 S' + W~ S) dpsi' + (S'' + A~ S + W~ S') dpsi

#include <Eigen/Dense>
#include <array>

#include "strandyn/beam/rigid_inertia.hpp"
#include "strandyn/math/rotation.hpp"
#include "strandyn/math/stumpff.hpp"

namespace strandyn::beam {

/// A rotation vector and what follows from it alone.
class BodyTurn {
 public:
  explicit BodyTurn(const Eigen::Vector3d& psi) : psi_(psi), c_(math::stumpff(psi.squaredNorm())) {}

  const Eigen::Vector3d& psi() const { return psi_; }
  const math::Stumpff& c() const { return c_; }

  Eigen::Vector3d to_space(const Eigen::Vector3d& v) const { return combine<0>(v, 1); }         ///< R v
  Eigen::Vector3d to_body(const Eigen::Vector3d& v) const { return combine<0>(v, -1); }         ///< R^T v
  Eigen::Vector3d spin(const Eigen::Vector3d& v) const { return combine<1>(v, -1); }            ///< S v
  Eigen::Vector3d spin_transposed(const Eigen::Vector3d& m) const { return combine<1>(m, 1); }  ///< S^T m
  Eigen::Matrix3d rotation() const { return combined_matrix<0>(1); }                            ///< R
  Eigen::Matrix3d spin_map() const { return combined_matrix<1>(-1); }                           ///< S

  /// d(S^T m)/dpsi for a fixed m, by S(psi) = T(-psi).
  Eigen::Matrix3d spin_transposed_slope(const Eigen::Vector3d& m) const {
    return -math::spin_map_transposed_slope(-psi_, m);
  }

  /// d/dt c_k = slope(k) psi . psi', d/dt slope(k) = second_slope(k) psi . psi'.
  double slope(std::size_t k) const { return 2 * math::stumpff_derivative(c_, k); }
  double second_slope(std::size_t k) const { return 4 * math::stumpff_second_derivative(c_, k); }

 private:
  /// c_k v + sign c_{k+1} psi x v + c_{k+2} (psi . v) psi.
  template <std::size_t k>
  Eigen::Vector3d combine(const Eigen::Vector3d& v, double sign) const {
    return c_[k] * v + sign * c_[k + 1] * psi_.cross(v) + c_[k + 2] * psi_.dot(v) * psi_;
  }
  template <std::size_t k>
  Eigen::Matrix3d combined_matrix(double sign) const {
    Eigen::Matrix3d m = sign * c_[k + 1] * math::skew(psi_) + c_[k + 2] * psi_ * psi_.transpose();
    m.diagonal().array() += c_[k];
    return m;
  }

  Eigen::Vector3d psi_;
  math::Stumpff c_;
};

/// [rad/s], [rad/s^2] Angular velocity and acceleration, in the axes of the body.
struct BodySpin {
  Eigen::Vector3d W, A;
};

inline BodySpin body_spin(const BodyTurn& turn, const RotationMotion& m) {
  const Eigen::Vector3d& psi = turn.psi();
  const double along = psi.dot(m.rate);
  const double c3 = turn.c()[3];
  return {.W = turn.spin(m.rate),
          .A = turn.spin(m.acceleration) + along * ((turn.slope(1) + c3) * m.rate - turn.slope(2) * psi.cross(m.rate)) +
               (turn.slope(3) * along * along + c3 * m.rate.squaredNorm()) * psi};
}

/// The derivatives of W and A; dW/dpsi' = dA/dpsi'' = S.
struct BodySpinTangent {
  Eigen::Matrix3d S, W_psi, A_rate, A_psi;
};

inline BodySpinTangent body_spin_tangent(const BodyTurn& turn, const RotationMotion& m, const BodySpin& spin) {
  const Eigen::Vector3d& psi = turn.psi();
  const math::Stumpff& c = turn.c();
  const double along = psi.dot(m.rate);
  const double along_rate = m.rate.squaredNorm() + psi.dot(m.acceleration);
  // First and second time derivatives of c_1, c_2, c_3.
  std::array<double, 4> c_t{}, c_tt{};
  for (std::size_t k = 1; k <= 3; ++k) {
    c_t[k] = turn.slope(k) * along;
    c_tt[k] = turn.slope(k) * along_rate + turn.second_slope(k) * along * along;
  }
  // S = c_1 - c_2 psi~ + c_3 psi psi^T, differentiated by the product rule.
  const Eigen::Matrix3d S = turn.spin_map();
  const Eigen::Vector3d half = c_t[3] / 2 * psi + c[3] * m.rate;
  Eigen::Matrix3d S_t = half * psi.transpose() + psi * half.transpose() - math::skew(c_t[2] * psi + c[2] * m.rate);
  S_t.diagonal().array() += c_t[1];
  const Eigen::Vector3d half_t = c_tt[3] / 2 * psi + 2 * c_t[3] * m.rate + c[3] * m.acceleration;
  Eigen::Matrix3d S_tt = half_t * psi.transpose() + psi * half_t.transpose() + 2 * c[3] * m.rate * m.rate.transpose() -
                         math::skew(c_tt[2] * psi + 2 * c_t[2] * m.rate + c[2] * m.acceleration);
  S_tt.diagonal().array() += c_tt[1];

  const Eigen::Matrix3d W_cross_S = math::crossed(spin.W, S);
  return {.S = S,
          .W_psi = S_t + W_cross_S,
          .A_rate = 2 * S_t + W_cross_S,
          .A_psi = S_tt + math::crossed(spin.A, S) + math::crossed(spin.W, S_t)};
}

}  // namespace strandyn::beam
