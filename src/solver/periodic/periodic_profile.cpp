// Nodes and antinodes along a chain in steady vibration.

#include <cmath>
#include <stdexcept>

#include "strandyn/solver/periodic/periodic.hpp"

namespace strandyn::solver {

using model::Unknown;

namespace {

constexpr int parts = 16;  // of an element

struct EnvelopePoint {
  double position = 0;  // [m]
  double square = 0;    // [m^2]
};

/// The vertex of the parabola through three neighbours: near a node the square is one, near an antinode almost.
LoopPoint vertex(const EnvelopePoint& a, const EnvelopePoint& b, const EnvelopePoint& c) {
  const double left = (b.square - a.square) / (b.position - a.position);
  const double right = (c.square - b.square) / (c.position - b.position);
  const double curve = (right - left) / (c.position - a.position);
  const double slope = left + curve * (b.position - a.position);  // at b
  const double shift = -slope / (2 * curve);
  return {.antinode = curve < 0,
          .position = b.position + shift,
          .amplitude = std::sqrt(std::max(0.0, b.square + slope * shift / 2))};
}

}  // namespace

std::vector<LoopPoint> loop_points(const model::Model& model, Unknown across, const Eigen::VectorXcd& motion) {
  if (across != Unknown::y && across != Unknown::z) {
    throw std::invalid_argument("nodes and antinodes need a motion across the chain, y or z");
  }
  // About y a positive rotation is a falling slope.
  const Unknown rotation = across == Unknown::y ? Unknown::rotation_z : Unknown::rotation_y;
  const double hand = across == Unknown::y ? 1 : -1;
  const auto at = [&](std::size_t node, Unknown unknown) {
    return motion(static_cast<Eigen::Index>(*model.index(node, unknown)));
  };
  const std::vector<double> position = model::arc_lengths(model);
  std::vector<EnvelopePoint> envelope;
  for (std::size_t e = 0; e < model.elements.size(); ++e) {
    const double l = position[e + 1] - position[e];
    const auto y1 = at(e, across);
    const auto y2 = at(e + 1, across);
    const auto t1 = hand * l * at(e, rotation);
    const auto t2 = hand * l * at(e + 1, rotation);
    for (int i = e == 0 ? 0 : 1; i <= parts; ++i) {
      const double s = static_cast<double>(i) / parts;
      const auto y = (1 - s) * (1 - s) * (1 + 2 * s) * y1 + s * (1 - s) * (1 - s) * t1 + s * s * (3 - 2 * s) * y2 -
                     s * s * (1 - s) * t2;
      envelope.push_back({.position = position[e] + s * l, .square = std::norm(y)});
    }
  }
  std::vector<LoopPoint> points;
  for (std::size_t i = 1; i + 1 < envelope.size(); ++i) {
    const double before = envelope[i].square - envelope[i - 1].square;
    const double after = envelope[i + 1].square - envelope[i].square;
    if (before * after < 0 || (after == 0 && before != 0)) {
      points.push_back(vertex(envelope[i - 1], envelope[i], envelope[i + 1]));
    }
  }
  return points;
}

std::vector<LoopPoint> PeriodicSolver::loop_points(const PeriodicState& state) const {
  const Eigen::MatrixXd& x = state.harmonics;
  Eigen::VectorXcd motion(x.rows());
  motion.real() = x.col(1);
  motion.imag() = -x.col(2);
  return solver::loop_points(system_.model(), setup_.control.unknown, motion);
}

}  // namespace strandyn::solver
