#include "strandyn/analysis/damped_end.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "support/check_close.hpp"

using namespace strandyn::analysis;
using std::numbers::pi;
using strandyn::test::check_close;
using Complex = std::complex<double>;

namespace {

constexpr DampedEnd drake{.tension = 28e3, .mass_per_length = 1.628, .distance = 1.1};
const double wave_impedance = std::sqrt(drake.tension * drake.mass_per_length);
constexpr double amplitude = 5e-3;

/// A damper that is an impedance [N s/m] against displacement alone.
PointStiffness impedance(Complex Z, double frequency) {
  return {.force = Complex(0, 2 * pi * frequency) * Z, .coupling = 0, .moment = 0};
}

DampedEnd with_stiffness(double EI) {
  DampedEnd end = drake;
  end.EI = EI;
  return end;
}

}  // namespace

TEST_CASE("damped end: what the damper takes is what the waves bring and do not carry back") {
  for (const double EI : {0.0, 30.0, 1444.0}) {
    for (const Complex Z : {Complex(100, 0), Complex(50, -300), Complex(400, 900)}) {
      for (const double f : {8.0, 20.0, 33.0}) {
        const EndMotion m = motion_of(with_stiffness(EI), impedance(Z, f), f, amplitude);
        // With A = |a| + |b| and r = |b|/|a|: |a|^2 - |b|^2 = A^2 (1 - r)/(1 + r).
        const double omega = 2 * pi * f, T = drake.tension, mass = drake.mass_per_length;
        const double k2 = 2 * mass * omega * omega / (T + std::sqrt(T * T + 4 * EI * mass * omega * omega));
        const double flow = (T + 2 * EI * k2) * std::sqrt(k2) * omega * amplitude * amplitude / 2;
        check_close(m.power, flow * (1 - m.reflection) / (1 + m.reflection), {.relative = 1e-9});
      }
    }
  }
}

TEST_CASE("damped end: a beam without stiffness is the string") {
  for (const double f : {8.0, 20.0, 33.0}) {
    const EndMotion beam = motion_of(with_stiffness(1e-6), impedance(Complex(80, -200), f), f, amplitude);
    const EndMotion string = motion_of(drake, impedance(Complex(80, -200), f), f, amplitude);
    check_close(beam.power, string.power, {.relative = 1e-4});
    check_close(beam.damper_velocity, string.damper_velocity, {.relative = 1e-4});
    check_close(beam.end_amplitude, string.end_amplitude, {.relative = 1e-4});
  }
}

TEST_CASE("damped end: without a damper a stiff end holds the wave off by sqrt(EI/T)") {
  constexpr double EI = 1444;
  const EndMotion stiff = motion_of(with_stiffness(EI), {}, 5, amplitude);
  const double omega = 2 * pi * 5, k = omega / std::sqrt(drake.tension / drake.mass_per_length);
  const double held_off = std::sqrt(EI / drake.tension);
  check_close(stiff.damper_velocity, omega * amplitude * std::sin(k * (drake.distance - held_off)), {.relative = 0.01});
  check_close(stiff.end_amplitude, amplitude, {.relative = 1e-9});
}

TEST_CASE("damped end: a matched damper at a quarter of a wave sends nothing back") {
  const double f = std::sqrt(drake.tension / drake.mass_per_length) / (4 * drake.distance);
  const EndMotion m = motion_of(drake, impedance(wave_impedance, f), f, amplitude);
  CHECK(m.reflection < 1e-12);
  const double V = 2 * pi * f * amplitude;
  check_close(m.power, wave_impedance * V * V / 2, {.relative = 1e-12});
  check_close(m.damper_velocity, V, {.relative = 1e-12});
}

TEST_CASE("damped end: no damper, a damper at a node, a rigid damper") {
  const EndMotion none = motion_of(drake, {}, 20, amplitude);
  check_close(none.end_amplitude, amplitude, {.relative = 1e-12});
  check_close(none.reflection, 1.0, {.relative = 1e-12});
  CHECK(none.power == 0);
  const double at_node = std::sqrt(drake.tension / drake.mass_per_length) / (2 * drake.distance);
  CHECK(motion_of(drake, impedance(300, at_node), at_node, amplitude).power < 1e-20);
  const EndMotion rigid = motion_of(drake, impedance(Complex(0, 1e9), 20), 20, amplitude);
  CHECK(rigid.damper_velocity < 1e-3);
  CHECK(rigid.end_amplitude < 1e-4);
}

TEST_CASE("damped end: a damper that is turned takes what the waves bring as well") {
  const PointStiffness damper{.force = Complex(-9e3, 4e3), .coupling = Complex(700, -300), .moment = Complex(-90, 80)};
  for (const double f : {12.0, 25.0}) {
    const EndMotion m = motion_of(with_stiffness(1444), damper, f, amplitude);
    const double omega = 2 * pi * f, T = drake.tension, mass = drake.mass_per_length, EI = 1444;
    const double k2 = 2 * mass * omega * omega / (T + std::sqrt(T * T + 4 * EI * mass * omega * omega));
    const double flow = (T + 2 * EI * k2) * std::sqrt(k2) * omega * amplitude * amplitude / 2;
    CHECK(m.power > 0);
    check_close(m.power, flow * (1 - m.reflection) / (1 + m.reflection), {.relative = 1e-9});
  }
}
