#pragma once
/// \file A span that is moved by hand: observers see exactly the motion that a test prescribes.

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "strandyn/observe/step_record.hpp"
#include "system/spans.hpp"

namespace strandyn::test {

/// Deflection [m], its rate [m/s] and acceleration [m/s^2] at a time.
struct Swing {
  double deflection = 0;
  double rate = 0;
  double acceleration = 0;
};

/// How far a place moves and turns for a swing of one metre. [-], [rad/m]
struct ShapeAt {
  double value = 0;
  double slope = 0;
};

/// Sines of a given loop length. [m]
inline auto sine_shape(double loop) {
  return [k = std::numbers::pi / loop](double x) {
    return ShapeAt{.value = std::sin(k * x), .slope = k * std::cos(k * x)};
  };
}

class Driven {
 public:
  /// The nodes between the supports move across the span by `shape` times the swing.
  Driven(model::Model span, std::function<ShapeAt(double)> shape, std::function<Swing(double)> swing)
      : model(std::move(span)), system(model), shape_(zeros(model)), swing_(std::move(swing)) {
    for (std::size_t i = 1; i + 1 < model.nodes.size(); ++i) {
      const ShapeAt at = shape(model.nodes[i].x());
      shape_(static_cast<Eigen::Index>(3 * i + 1)) = at.value;
      shape_(static_cast<Eigen::Index>(3 * i + 2)) = at.slope;
    }
    system.begin(swing_(0).deflection * shape_);
  }

  void begin(observe::Observer& observer) { observer.begin(system, record(0)); }
  void step_to(observe::Observer& observer, double time) { observer.step(system, record(time)); }

  model::Model model;
  system::System system;

 private:
  observe::StepRecord record(double time) {
    const Swing swing = swing_(time);
    u_ = swing.deflection * shape_;
    v_ = swing.rate * shape_;
    a_ = swing.acceleration * shape_;
    const double step = time - std::exchange(time_, time);
    const system::Accepted accepted = system.commit(u_.data());
    external_ = internal_ = system.make_vector();
    system.forces({.u = u_.data(), .v = v_.data(), .a = a_.data()}, {.time = time}, external_, internal_);
    return {.time = time,
            .step = step,
            .order = 2,
            .u = u_,
            .v = v_,
            .a = a_,
            .external = external_,
            .internal = internal_,
            .accepted = accepted};
  }

  system::Vector shape_, u_, v_, a_, external_, internal_;
  std::function<Swing(double)> swing_;
  double time_ = 0;
};

}  // namespace strandyn::test
