#include "strandyn/solver/time/method.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace strandyn::solver {

double Ida::damping_ratio(double angle) const {
  return std::pow(angle, 3) / 4;
}

double Ida::frequency_error(double angle) const {
  return -angle * angle / 3;
}

double GeneralizedAlpha::damping_ratio(double angle) const {
  const double k = (1 - rho_inf) / (1 + rho_inf);
  return k * k * k * angle * angle * angle / 2;
}

double GeneralizedAlpha::frequency_error(double angle) const {
  const double k = (1 - rho_inf) / (1 + rho_inf);
  return -(1.0 / 12 + 3 * k * k / 8) * angle * angle;
}

double GeneralizedAlpha::stretch(double angle) const {
  if (!(angle > 0 && angle < std::numbers::pi)) return 1;
  const std::complex<double> z = std::polar(1.0, angle);
  const std::complex<double> averages = ((1 - alpha_m()) * z + alpha_m()) / ((1 - alpha_f()) * z + alpha_f());
  const std::complex<double> way =
      (1 - gamma() + gamma() * z) / ((z - 1.0) * (z - 1.0)) + (0.5 - beta() + beta() * z) / (z - 1.0);
  const double square = std::real(-averages / way);
  return square > 0 ? std::sqrt(square) / angle : 1;
}

const char* name_of(const TimeMethod& method) {
  return std::visit([](const auto& m) { return m.name; }, method);
}

double damping_ratio(const TimeMethod& method, double angle) {
  return std::visit([&](const auto& m) { return m.damping_ratio(angle); }, method);
}

double frequency_error(const TimeMethod& method, double angle) {
  return std::visit([&](const auto& m) { return m.frequency_error(angle); }, method);
}

int steps_for(const TimeMethod& method, const StepDemand& demand) {
  const int least = std::visit([](const auto& m) { return m.least_steps; }, method);
  constexpr double most = 4000;
  if (demand.damping_ratio == 0) return least;
  // The damping goes with the third power of the angle per step.
  const double unit = damping_ratio(method, 1);
  const double angle = unit > 0 ? std::cbrt(demand.share * demand.damping_ratio / unit) : 1;
  const double steps = std::clamp<double>(2 * std::numbers::pi / angle, least, most);
  return 4 * static_cast<int>(std::ceil(steps / 4));
}

}  // namespace strandyn::solver
