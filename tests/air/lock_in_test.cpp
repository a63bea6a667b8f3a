#include "strandyn/air/lock_in.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "support/check_close.hpp"

using namespace strandyn::air;
using std::numbers::pi;
using strandyn::test::check_close;

namespace {

WakeModel wake() {
  WakeModel model;
  model.diameter = 0.03;
  return model;
}

}  // namespace

TEST_CASE("lock-in: both equations hold in their fundamental") {
  for (const double mass_ratio : {2.0, 20.0, 1600.0}) {
    for (const double reduced : {3.0, 4.8, 5.0, 5.6, 7.0, 9.0}) {
      CAPTURE(mass_ratio);
      CAPTURE(reduced);
      const CylinderOnSprings cylinder{
          .mass = (mass_ratio + 1) * wake().mass_of_air(), .frequency = 5, .damping_ratio = 2e-3};
      const double speed = reduced * 5 * 0.03;
      const auto branches = lock_in(wake(), cylinder, speed);
      REQUIRE(!branches.empty());
      CHECK(branches.size() <= 3);
      for (const LockedIn& branch : branches) {
        // Put into the equations, samples of a cycle give no force at the fundamental.
        const double W = 2 * pi * branch.frequency, omega = 2 * pi * 5, omega_f = wake().angular_frequency(speed);
        const double damping = 2 * cylinder.mass * 2e-3 * omega + wake().damping(speed);
        const std::complex<double> Y = wake().lift_per_q(speed) * branch.wake_amplitude /
                                       std::complex(cylinder.mass * (omega * omega - W * W), W * damping);
        check_close(std::abs(Y), branch.amplitude, {.relative = 1e-10});
        std::complex<double> rest;
        constexpr int samples = 64;
        for (int i = 0; i < samples; ++i) {
          const std::complex<double> turn = std::polar(1.0, 2 * pi * i / samples);
          const double q = branch.wake_amplitude * turn.real(), rate = -W * branch.wake_amplitude * turn.imag();
          const double acceleration = -W * W * (Y * turn).real();
          const double wake_force = -W * W * q + wake().epsilon * omega_f * (q * q - 1) * rate + omega_f * omega_f * q -
                                    wake().coupling / 0.03 * acceleration;
          rest += wake_force * std::conj(turn) * 2.0 / static_cast<double>(samples);
        }
        CHECK(std::abs(rest) < 1e-8 * omega_f * omega_f * branch.wake_amplitude);
      }
    }
  }
}

TEST_CASE("lock-in: a cylinder too heavy to move leaves the wake of one at rest") {
  const auto branches = lock_in(wake(), {.mass = 1e9, .frequency = 50, .damping_ratio = 0.1}, 1.0);
  REQUIRE(branches.size() == 1);
  check_close(branches[0].wake_amplitude, 2, {.relative = 1e-9});
  check_close(branches[0].frequency, 0.2 / 0.03, {.relative = 1e-9});
}

TEST_CASE("lock-in: at the edges of lock-in there are three branches and one within and far from it") {
  const CylinderOnSprings cylinder{.mass = 101 * wake().mass_of_air(), .frequency = 5, .damping_ratio = 1e-3};
  const auto branches = [&](double reduced) { return lock_in(wake(), cylinder, reduced * 5 * 0.03).size(); };
  CHECK(branches(2.0) == 1);
  CHECK(branches(4.5) == 3);
  CHECK(branches(5.0) == 1);
  CHECK(branches(5.5) == 3);
  CHECK(branches(9.0) == 1);
}
