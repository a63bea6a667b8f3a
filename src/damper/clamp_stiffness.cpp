#include "strandyn/damper/clamp_stiffness.hpp"

namespace strandyn::damper {

Eigen::Matrix2cd clamp_stiffness(const Arm& arm, const ElasticMessenger& messenger, double omega) {
  const double l = arm.length, e = arm.weight.eccentricity, m = arm.weight.mass;
  Eigen::Matrix4d K, M;  // y and theta of the clamp, of the messenger's end
  K << 12, 6 * l, -12, 6 * l, 6 * l, 4 * l * l, -6 * l, 2 * l * l, -12, -6 * l, 12, -6 * l, 6 * l, 2 * l * l, -6 * l,
      4 * l * l;
  K *= messenger.EI / (l * l * l);
  M << 156, 22 * l, 54, -13 * l, 22 * l, 4 * l * l, 13 * l, -3 * l * l, 54, 13 * l, 156, -22 * l, -13 * l, -3 * l * l,
      -22 * l, 4 * l * l;
  M *= messenger.mass_per_length * l / 420;
  // The centre of the weight lies e before the messenger's end: its velocity is that of the end less e times the rate.
  M(2, 2) += m;
  M(2, 3) -= m * e;
  M(3, 2) -= m * e;
  M(3, 3) += arm.weight.inertia + m * e * e;
  const Eigen::Matrix4cd D = Complex(1, messenger.loss_factor) * K.cast<Complex>() - omega * omega * M.cast<Complex>();
  const Eigen::Matrix2cd of_weight = D.bottomRightCorner<2, 2>();
  return D.topLeftCorner<2, 2>() -
         D.topRightCorner<2, 2>() * of_weight.partialPivLu().solve(Eigen::Matrix2cd(D.bottomLeftCorner<2, 2>()));
}

}  // namespace strandyn::damper
