#include "strandyn/air/wake_oscillator.hpp"

#include <cmath>
#include <numbers>

namespace strandyn::air {

using std::numbers::pi;

double WakeModel::angular_frequency(double speed) const {
  return 2 * pi * strouhal * speed / diameter;
}

double WakeModel::lift_per_q(double speed) const {
  return density * speed * speed * diameter * lift / 4;
}

double WakeModel::damping(double speed) const {
  return stall * angular_frequency(speed) * density * diameter * diameter;
}

double WakeModel::mass_of_air() const {
  return added_mass * density * pi * diameter * diameter / 4;
}

Wake advance(const WakeModel& model, double speed, Wake wake, const StepOfCylinder& step) {
  constexpr double substeps_per_period = 40;
  const double omega = model.angular_frequency(speed);
  const int n = std::max(1, static_cast<int>(std::ceil(substeps_per_period * omega * step.length / (2 * pi))));
  const double h = step.length / n;
  const auto rate_of = [&](const Wake& w, double part) {
    const double acceleration = step.from + part * (step.to - step.from);
    return Wake{.q = w.rate,
                .rate = model.coupling / model.diameter * acceleration -
                        omega * (model.epsilon * (w.q * w.q - 1) * w.rate + omega * w.q)};
  };
  const auto moved = [](const Wake& w, double time, const Wake& rate) {
    return Wake{.q = w.q + time * rate.q, .rate = w.rate + time * rate.rate};
  };
  for (int i = 0; i < n; ++i) {
    const double begin = static_cast<double>(i) / n, middle = (i + 0.5) / n, end = (i + 1.0) / n;
    const Wake k1 = rate_of(wake, begin);
    const Wake k2 = rate_of(moved(wake, h / 2, k1), middle);
    const Wake k3 = rate_of(moved(wake, h / 2, k2), middle);
    const Wake k4 = rate_of(moved(wake, h, k3), end);
    wake.q += h / 6 * (k1.q + 2 * k2.q + 2 * k3.q + k4.q);
    wake.rate += h / 6 * (k1.rate + 2 * k2.rate + 2 * k3.rate + k4.rate);
  }
  return wake;
}

}  // namespace strandyn::air
