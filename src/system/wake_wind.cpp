#include <numbers>
#include <random>

#include "across_nodes.hpp"
#include "strandyn/system/system.hpp"
#include "strandyn/system/wind.hpp"

namespace strandyn::system {
namespace {

class WakesOnChain final : public WindOnChain {
 public:
  WakesOnChain(const model::WakeWind& wind, const model::Model& model)
      : wind_(wind), nodes_(across_nodes(model)), wakes_(nodes_.size()), acceleration_(nodes_.size(), 0.0) {
    std::mt19937 random(wind.seed.value_or(0));  // the numbers of this generator are the same everywhere
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const double part = static_cast<double>(random()) / 4294967296.0;  // of a turn
      const double phase = wind.seed ? 2 * std::numbers::pi * part : 0;
      wakes_[i] = {
          .q = wind.amplitude * std::cos(phase),
          .rate = -wind.amplitude * wind.wake.angular_frequency(wind.shear[i] * speed_at(0)) * std::sin(phase)};
    }
  }

  void subtract_force(const State& state, double time, double* f) const override {
    const double on_the_way = speed_at((time_ + time) / 2), speed = speed_at(time);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const double acceleration = state.a[nodes_[i].unknown];
      const air::Wake wake = after(i, time, on_the_way, acceleration);
      f[nodes_[i].unknown] -= nodes_[i].length * force(i, speed, wake, state.v[nodes_[i].unknown]);
    }
  }

  void subtract_tangent(double factor, math::ChainMatrix& K) const override {
    const double speed = speed_at(time_);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const double damping = nodes_[i].length * wind_.wake.damping(wind_.shear[i] * speed);
      K.add_at_node(nodes_[i].unknown, nodes_[i].unknown, factor * damping);
    }
  }

  double power(const State& state) const override {
    double power = 0;
    const double speed = speed_at(time_);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const double velocity = state.v[nodes_[i].unknown];
      power += nodes_[i].length * velocity * force(i, speed, wakes_[i], velocity);
    }
    return power;
  }

  void commit(const State& state, double time) override {
    const double on_the_way = speed_at((time_ + time) / 2);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const double acceleration = state.a[nodes_[i].unknown];
      wakes_[i] = after(i, time, on_the_way, acceleration);
      acceleration_[i] = acceleration;
    }
    time_ = time;
  }

  void archive(Archive& a) override {
    for (air::Wake& wake : wakes_) a(wake.q, wake.rate);
    a(acceleration_, time_);
  }

 private:
  /// [m/s] without shear.
  double speed_at(double time) const {
    return wind_.speed * math::evaluate(wind_.history, time) * wind_.gusts.at(time);
  }

  /// The wake at the end of a step that goes from the last commit to `time`, in a wind of that speed.
  air::Wake after(std::size_t i, double time, double speed, double acceleration) const {
    if (time <= time_) return wakes_[i];
    return air::advance(wind_.wake, wind_.shear[i] * speed, wakes_[i],
                        {.length = time - time_, .from = acceleration_[i], .to = acceleration});
  }

  /// [N/m] upward.
  double force(std::size_t i, double speed, const air::Wake& wake, double velocity) const {
    const double U = wind_.shear[i] * speed;
    return wind_.wake.lift_per_q(U) * wake.q - wind_.wake.damping(U) * velocity;
  }

  model::WakeWind wind_;
  std::vector<AcrossNode> nodes_;
  std::vector<air::Wake> wakes_;
  std::vector<double> acceleration_;  // [m/s^2] of the last commit
  double time_ = 0;                   // [s] of the last commit
};

}  // namespace

std::unique_ptr<WindOnChain> make_wake_wind(const model::Model& model) {
  return std::make_unique<WakesOnChain>(std::get<model::WakeWind>(*model.wind), model);
}

}  // namespace strandyn::system
