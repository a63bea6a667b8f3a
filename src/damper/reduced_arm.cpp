#include "strandyn/damper/reduced_arm.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace strandyn::damper {

using std::numbers::pi;

namespace {

/// Gauss's points on [0, 1], exact to degree 11: the stiffness falls steeply where slip begins.
struct GaussPoint {
  double place, weight;
};
constexpr std::array<GaussPoint, 6> gauss = {{{0.03376524289842397, 0.08566224618958517},
                                              {0.16939530676686775, 0.18038078652406930},
                                              {0.38069040695840156, 0.23395696728634552},
                                              {0.61930959304159844, 0.23395696728634552},
                                              {0.83060469323313225, 0.18038078652406930},
                                              {0.96623475710157603, 0.08566224618958517}}};

constexpr int most_rounds = 60;
constexpr double tolerance = 1e-10;  // [-] of a correction
constexpr double probe = 1e-6;       // [-] of the unknowns, for differences
constexpr int doublings = 8;         // from where little slips

/// How much a Hermite element of length l curves at x (part of l) per w - y and per phi.
std::array<double, 2> curvature_shape(double l, double part) {
  return {(6 - 12 * part) / (l * l), (6 * part - 2) / l};
}

}  // namespace

ReducedArm::ReducedArm(const Arm& arm, const Messenger& messenger, const BendingLoops& loops)
    : arm_(arm), messenger_(messenger), loops_(loops) {}

ReducedArm::Force ReducedArm::force_at(const Shake& shake, const Unknowns& x) const {
  const double l = arm_.length;
  const double omega = shake.omega();
  const double y = shake.displacement();
  Force f{};
  // Bending: work-conjugate to w - y and phi; the clamp feels what w feels, the other way.
  Unknowns bending{};
  const double metal = section::loss_at(messenger_.material, section::Component::bending2, omega);
  for (const GaussPoint& at : gauss) {
    const auto shape = curvature_shape(l, at.place);
    const Complex chi = shape[0] * x[0] + shape[1] * x[1];
    const double size = std::abs(chi);
    const Complex loops = loops_.stiffness(size);
    const Complex moment = (loops + Complex{0, metal}) * chi;
    for (std::size_t i = 0; i < 2; ++i) bending[i] += l * at.weight * shape[i] * moment;
    f.friction += l * at.weight * pi * loops.imag() * size * size;
    f.material += l * at.weight * pi * metal * size * size;
  }
  // Inertia: the weight about the messenger's end, the messenger's consistent mass.
  const Weight& body = arm_.weight;
  const double e = body.eccentricity;
  const Complex w = y + x[0];
  const Complex phi = x[1];
  const double beam = messenger_.mass_per_length * l / 420;
  const Complex of_clamp = beam * (156.0 * y + 54.0 * w - 13.0 * l * phi);
  const Complex of_w = beam * (54.0 * y + 156.0 * w - 22.0 * l * phi) + body.mass * (w - e * phi);
  const Complex of_phi = beam * (-13.0 * l * y - 22.0 * l * w + 4.0 * l * l * phi) - body.mass * e * w +
                         (body.inertia + body.mass * e * e) * phi;
  const double square = omega * omega;
  f.clamp = -bending[0] - square * of_clamp;
  f.on_weight = {bending[0] - square * of_w, bending[1] - square * of_phi};
  return f;
}

bool ReducedArm::solve(const Shake& shake, Unknowns& x) const {
  const double l = arm_.length;
  const double size_of_motion = shake.displacement();
  const auto pack = [&](const Unknowns& f) {
    return Eigen::Vector4d(f[0].real(), f[0].imag(), f[1].real() / l, f[1].imag() / l);
  };
  for (int round = 0; round < most_rounds; ++round) {
    const Eigen::Vector4d r = pack(force_at(shake, x).on_weight);
    const double size = std::max({std::abs(x[0]), std::abs(l * x[1]), size_of_motion});
    Eigen::Matrix4d J;
    for (int k = 0; k < 4; ++k) {
      Unknowns moved = x;
      const Complex along = k % 2 == 0 ? Complex{probe * size, 0} : Complex{0, probe * size};
      if (k < 2)
        moved[0] += along;
      else
        moved[1] += along / l;
      J.col(k) = (pack(force_at(shake, moved).on_weight) - r) / (probe * size);
    }
    const Eigen::Vector4d step = J.partialPivLu().solve(-r);
    if (!step.allFinite()) return false;
    const double part = std::min(1.0, 0.5 * size / std::max(step.cwiseAbs().maxCoeff(), 1e-300));
    x[0] += part * Complex{step(0), step(1)};
    x[1] += part * Complex{step(2), step(3)} / l;
    if (step.cwiseAbs().maxCoeff() <= tolerance * size) return true;
  }
  return false;
}

ArmAnswer ReducedArm::answer(const Shake& shake) {
  const double y = shake.displacement();
  Unknowns x{};
  if (has_last_) x = {last_[0] * y, last_[1] * y};
  bool found = solve(shake, x);
  if (!found) {  // from where little slips
    Shake low = shake;
    low.velocity *= std::pow(0.5, doublings);
    x = {};
    found = true;
    for (int k = 0; k <= doublings && found; ++k, low.velocity *= 2) {
      found = solve(low, x);
      if (k < doublings) x = {2.0 * x[0], 2.0 * x[1]};
    }
  }
  ArmAnswer answer{.converged = found, .failure = {}, .shake = shake};
  if (!found) answer.failure = "no convergence of the two unknowns";
  has_last_ = found;
  if (found) last_ = {x[0] / y, x[1] / y};
  const Force f = force_at(shake, x);
  const Complex ahead{0, 1};  // the displacement is real inside, the velocity outside
  answer.force = f.clamp / ahead;
  answer.tip = (y + x[0]) / ahead;
  answer.turn = x[1] / ahead;
  const auto at_clamp = curvature_shape(arm_.length, 0);
  answer.clamp_curvature = std::abs(at_clamp[0] * x[0] + at_clamp[1] * x[1]);
  answer.friction = f.friction;
  answer.material = f.material;
  return answer;
}

}  // namespace strandyn::damper
