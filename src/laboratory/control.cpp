#include "control.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::laboratory {

using Complex = std::complex<double>;
using std::numbers::pi;

namespace {

constexpr Complex i_unit{0, 1};
constexpr int most_returns = 1;

}  // namespace

void Control::read(const RunReading& r) {
  const double omega = 2 * pi * r.drive.frequency;
  const double push = r.drive.amplitude * plant_.coupling / (2 * omega * plant_.modal_mass);
  const Complex slope = (r.last - r.first) / r.between;
  const Complex middle = 0.5 * (r.last + r.first);
  const Complex rate = (slope + i_unit * push) / middle;
  omega_ = omega + rate.imag();
  rate_ = std::max(0.0, -rate.real());
  const Complex at_end = r.last + slope * r.after;
  modal_ = std::abs(at_end);
  modal_wanted_ = std::abs(middle) * wanted_ / r.antinode_amplitude;
  amplitude_error_ = r.antinode_amplitude / wanted_ - 1;
  phase_ = std::arg(i_unit * at_end);
  phase_wanted_ = 0;
  if (plant_.moves || r.drive.amplitude == 0) return;
  const double others = (r.driven - plant_.coupling * r.last).real() / r.drive.amplitude;  // R
  const double sine = -4 * omega * plant_.modal_mass * rate_ * others / (plant_.coupling * plant_.coupling);
  constexpr double largest = 0.9;
  const bool can_be = std::abs(sine) <= largest;
  if (can_be && !at_shaker_) ++returns_;
  at_shaker_ = can_be && returns_ <= most_returns;
  if (at_shaker_) phase_wanted_ = 0.5 * std::asin(sine);
}

Drive Control::drive_at(double omega, double push, double phase) const {
  return {.frequency = omega / (2 * pi),
          .amplitude = 2 * omega * plant_.modal_mass * push / (plant_.coupling * std::cos(phase))};
}

double Control::rate_at(double modal_amplitude) const {
  return rate_ * std::pow(std::clamp(modal_amplitude / modal_, 0.8, 1.25), plant_.exponent - 2);
}

Drive Control::corrected(double time) const {
  // A fifth of what is wanted at most: the other modes are to stay at rest.
  const double step = std::clamp(modal_wanted_ - modal_, -0.2 * modal_wanted_, 0.2 * modal_wanted_);
  const double fading = std::max(plant_.exponent - 1, 0.1) * rate_;
  const double push = rate_at(modal_ + step) * (modal_ + step) +
                      step * (fading * time > 1e-9 ? fading / std::expm1(fading * time) : 1 / time);
  const double turn = std::clamp(phase_ - phase_wanted_, -0.5, 0.5);
  const double phase = std::clamp(phase_wanted_ + turn / 2, -1.0, 1.0);
  return drive_at(omega_ - rate_ * std::tan(phase) + turn / time, push, phase);
}

std::vector<double> Control::way_out(std::size_t n, double above) const {
  const auto parts = [n](double peak) {
    std::vector<double> drive;
    const auto steps = static_cast<double>(n);
    for (std::size_t i = 1; i <= n; ++i) drive.push_back(1 + (peak - 1) * static_cast<double>(i) / steps);
    for (std::size_t i = 1; i < n; ++i) drive.push_back(peak * (1 - static_cast<double>(i) / steps));
    return drive;
  };
  // What the amplitude is off by follows e' = -mu e + lambda (drive - 1), so the peak is found by a straight line.
  const double fading = std::max(plant_.exponent - 1, 0.1) * rate_;
  const auto off_after = [&](double peak) {
    const double left = std::exp(-fading * 2 * pi / omega_);
    double off = 0;
    for (const double drive : parts(peak)) off = left * off + (1 - left) * rate_ / fading * (drive - 1);
    return off;
  };
  if (fading == 0) return parts(1);
  const double low = off_after(1);
  constexpr double largest = 4;
  return parts(std::clamp(1 + (above - low) / (off_after(2) - low), 1.0, largest));
}

Drive Control::held() const {
  return drive_at(omega_ - rate_ * std::tan(phase_wanted_), rate_at(modal_wanted_) * modal_wanted_, phase_wanted_);
}

}  // namespace strandyn::laboratory
