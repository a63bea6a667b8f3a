#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "across_nodes.hpp"
#include "strandyn/system/system.hpp"
#include "strandyn/system/wind.hpp"

namespace strandyn::system {
namespace {

using std::numbers::pi;

using Complex = std::complex<double>;

/// The nodes of a loop: neighbours on one side of the axis.
struct Loop {
  std::vector<AcrossNode> nodes;
  std::vector<Complex> swing;  // [m/s] V of each
  double scale = 0;            // [1/m] max phi^2/(sum l phi^2)
};

class LockedInWindOnChain final : public WindOnChain {
 public:
  LockedInWindOnChain(const model::LockedInWind& wind, const model::Model& model, const LockedMode& mode)
      : wind_(wind.wind),
        omega_(2 * pi * mode.frequency),
        lag_(std::max<double>(least_lag, static_cast<double>(mode.number)) / mode.frequency),
        rest_(mode.rest) {
    projection_ = mode.momentum / mode.momentum.dot(mode.shape);
    bool was_up = false;
    double largest = 0, squares = 0;
    for (const AcrossNode& node : across_nodes(model)) {
      const double phi = mode.shape(static_cast<Eigen::Index>(node.unknown));
      if (phi == 0) continue;  // at a support
      const bool is_up = phi > 0;
      if (loops_.empty() || is_up != was_up) {
        loops_.emplace_back();
        largest = squares = 0;
      }
      was_up = is_up;
      Loop& loop = loops_.back();
      loop.nodes.push_back(node);
      loop.swing.emplace_back(mode.velocity * phi);
      largest = std::max(largest, crest(model, mode.shape, node));
      squares += node.length * phi * phi;
      loop.scale = largest * largest / squares;
    }
  }

  void subtract_force(const State& state, double, double* f) const override {
    const Complex p = phasor(state);
    for (const Loop& loop : loops_) {
      const double c = factor(loop);
      for (std::size_t i = 0; i < loop.nodes.size(); ++i) {
        f[loop.nodes[i].unknown] -= c * loop.nodes[i].length * (loop.swing[i] * p).real();
      }
    }
  }

  double power(const State& state) const override {
    const Complex p = phasor(state);
    double power = 0;
    for (const Loop& loop : loops_) {
      double moved = 0;
      for (std::size_t i = 0; i < loop.nodes.size(); ++i) {
        moved += loop.nodes[i].length * (loop.swing[i] * p).real() * state.v[loop.nodes[i].unknown];
      }
      power += factor(loop) * moved;
    }
    return power;
  }

  void commit(const State& state, double time) override {
    const double part = -std::expm1(-(time - time_) / lag_);
    time_ = time;
    if (!(part > 0)) return;
    const Complex back = std::conj(phasor(state));
    for (Loop& loop : loops_) {
      for (std::size_t i = 0; i < loop.nodes.size(); ++i) {
        loop.swing[i] += part * (2 * state.v[loop.nodes[i].unknown] * back - loop.swing[i]);
      }
    }
  }

  void archive(Archive& a) override {
    for (Loop& loop : loops_) a(loop.swing);
    a(time_);
  }

 private:
  static constexpr double least_lag = 10;  // periods

  /// The size of the shape at a node, or of the parabola through it and its neighbours where that is highest between.
  static double crest(const model::Model& model, const Eigen::VectorXd& shape, const AcrossNode& node) {
    const auto at = [&](std::size_t n) {
      return std::abs(shape(static_cast<Eigen::Index>(model.index(n, model::Unknown::y).value())));
    };
    const double here = at(node.node);
    if (node.node == 0 || node.node + 1 == model.nodes.size()) return here;
    const double before = at(node.node - 1), after = at(node.node + 1);
    if (here < before || here < after) return here;
    const double a = model.elements[node.node - 1].length, b = model.elements[node.node].length;
    const double slope = ((here - before) / a * b + (after - here) / b * a) / (a + b);
    const double bend = 2 * ((after - here) / b - (here - before) / a) / (a + b);
    return bend < 0 ? here - slope * slope / (2 * bend) : here;
  }

  /// Where the mode is in its cycle: 1 at the largest velocity. 1 at rest, too.
  Complex phasor(const State& state) const {
    const Eigen::Index n = rest_.size();
    const double value = projection_.dot(Eigen::Map<const Eigen::VectorXd>(state.u, n) - rest_);
    const double rate = projection_.dot(Eigen::Map<const Eigen::VectorXd>(state.v, n));
    const Complex p(rate, omega_ * value);
    const double size = std::abs(p);
    return size > 0 ? p / size : Complex(1);
  }

  /// c [N s/m^2] in a loop.
  double factor(const Loop& loop) const {
    double squares = 0;
    for (std::size_t i = 0; i < loop.nodes.size(); ++i) squares += loop.nodes[i].length * std::norm(loop.swing[i]);
    const double D = wind_.diameter;
    const double a = std::max(std::sqrt(loop.scale * squares) / (omega_ * D), wind_.curve.lowest);
    const double fnc = wind_.curve.at(std::min(a, wind_.curve.highest));
    const double frequency = omega_ / (2 * pi);
    return frequency * D * D * air::turbulence_factor(wind_.turbulence_intensity) * fnc / (pi * pi * a * a);
  }

  air::Wind wind_;
  double omega_;     // [rad/s]
  double lag_;       // [s] tau
  double time_ = 0;  // [s] of the last commit
  Eigen::VectorXd rest_, projection_;
  std::vector<Loop> loops_;
};

}  // namespace

std::unique_ptr<WindOnChain> make_locked_in_wind(const model::Model& model, const LockedMode& mode) {
  return std::make_unique<LockedInWindOnChain>(std::get<model::LockedInWind>(*model.wind), model, mode);
}

}  // namespace strandyn::system
