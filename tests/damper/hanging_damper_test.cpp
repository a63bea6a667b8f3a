// A damper on a span in time: on a clamp that is led as a sine it must be the one of the harmonic balance.
#include "strandyn/damper/hanging_damper.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "damper/dampers.hpp"
#include "strandyn/damper/arm_chain.hpp"
#include "strandyn/damper/clamp_stiffness.hpp"
#include "strandyn/system/system.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using damper::ArmChain;
using damper::Complex;
using damper::HangingArm;
using damper::Messenger;
using damper::Side;
using std::numbers::pi;
using test::check_close;

namespace {

/// One planar node.
model::Model clamp_only() {
  model::Model span;
  span.nodes.resize(1);
  return span;
}

struct Shaken {
  Complex force;      // [N] fundamental, the velocity of the clamp real
  double power = 0;   // [W] by what is lost
  double moment = 0;  // [N m] largest
};

/// The last of some cycles of a clamp whose velocity is V cos(wt), eased in.
Shaken shake(system::Attachment& hung, double frequency, double velocity, int cycles, int steps) {
  const double w = 2 * pi * frequency, h = 1 / (frequency * steps);
  Shaken shaken;
  for (int i = 0; i <= cycles * steps; ++i) {
    const double t = i * h;
    const double u[] = {0, velocity / w * std::sin(w * t), 0};
    const double v[] = {0, velocity * std::cos(w * t), 0};
    const double a[] = {0, -velocity * w * std::sin(w * t), 0};
    const system::State state{.u = u, .v = v, .a = a};
    double f[3] = {};
    hung.add_force(state, t, f);
    const double lost = hung.commit(state, t).lost;
    if (i <= (cycles - 1) * steps) continue;
    shaken.force += f[1] * std::polar(2.0 / steps, -w * t);
    shaken.power += lost * frequency;
    shaken.moment = std::max(shaken.moment, std::abs(f[2]));
  }
  return shaken;
}

void check_against_balance(const Messenger& messenger, double frequency, double velocity, int cycles) {
  const auto& both = test::stockbridges()[0];
  const model::Model span = clamp_only();
  const auto hung = damper::make_hanging_damper(
      span, {{.arm = both.arms[0], .side = Side::left}, {.arm = both.arms[1], .side = Side::right}}, messenger,
      {.node = 0, .elements = 6, .frequency = frequency});
  const Shaken shaken = shake(*hung, frequency, velocity, cycles, 400);
  Complex force = 0;
  double power = 0;
  for (const damper::Arm& arm : both.arms) {
    ArmChain chain(arm, messenger, {.elements = 6, .harmonics = 7, .samples = 128});
    const damper::ArmAnswer answer = chain.answer({.frequency = frequency, .velocity = velocity});
    REQUIRE_MESSAGE(answer.converged, answer.failure);
    force += answer.force;
    power += answer.power();
  }
  CHECK(std::abs(shaken.force - force) < 0.01 * std::abs(force));
  check_close(shaken.power, power, {.relative = 0.01});
}

}  // namespace

TEST_CASE(
    "hanging damper: on a shaker it is the damper of the harmonic balance, elastic messenger with a loss factor") {
  const auto& both = test::stockbridges()[0];
  const Messenger messenger = test::elastic_messenger(both.EI, both.mass_per_length, 0.1334);
  for (const double frequency : {14.0, 18.3, 30.0}) check_against_balance(messenger, frequency, 0.05, 60);
}

TEST_CASE("hanging damper: and with a messenger that slips") {
  for (const double frequency : {12.0, 16.0}) check_against_balance(test::slipping_messenger(), frequency, 0.05, 80);
}

TEST_CASE("hanging damper: two like arms ask for no moment, one arm is the other seen from behind") {
  const auto& both = test::stockbridges()[1];
  const Messenger messenger = test::elastic_messenger(both.EI, both.mass_per_length, 0.05);
  const model::Model span = clamp_only();
  const auto hang = [&](const std::vector<HangingArm>& arms) {
    const auto hung = damper::make_hanging_damper(span, arms, messenger, {.node = 0, .elements = 3, .frequency = 20});
    return shake(*hung, 20, 0.1, 3, 100);
  };
  const HangingArm left{.arm = both.arms[0], .side = Side::left}, right{.arm = both.arms[0], .side = Side::right};
  CHECK(hang({left, right}).moment < 1e-9);
  const Shaken alone = hang({left}), other = hang({right});
  CHECK(alone.moment > 0.1);
  check_close(alone.moment, other.moment, {.relative = 1e-12});
  check_close(std::abs(alone.force - other.force), 0.0, {.absolute = 1e-9});
}

TEST_CASE("hanging damper: a clamp that moves steadily takes the arms along as rigid bodies, without loss") {
  const auto& both = test::stockbridges()[0];
  const model::Model span = clamp_only();
  const auto hung =
      damper::make_hanging_damper(span, {{.arm = both.arms[0], .side = Side::right}}, test::slipping_messenger(),
                                  {.node = 0, .elements = 4, .frequency = 20});
  const double weight = both.arms[0].weight.mass + 0.768 * both.arms[0].length;
  double lost = 0, kinetic = 0;
  for (int i = 0; i <= 50; ++i) {
    const double t = i * 1e-3;
    const double u[] = {0, 0.3 * t, 0}, v[] = {0, 0.3, 0}, a[] = {0, 0, 0};
    const system::AttachedEnergy energy = hung->commit({.u = u, .v = v, .a = a}, t);
    lost += energy.lost;
    kinetic = energy.kinetic;
    CHECK(std::abs(energy.elastic) < 1e-12);
  }
  CHECK(lost < 1e-12);
  check_close(kinetic, weight * 0.09 / 2, {.relative = 1e-9});
}

TEST_CASE("hanging damper: a clamp that moves and turns feels the dynamic stiffness of both arms") {
  const auto& both = test::stockbridges()[0];
  const damper::ElasticMessenger elastic{.EI = both.EI, .mass_per_length = both.mass_per_length, .loss_factor = 0.1334};
  const Messenger messenger = test::elastic_messenger(elastic.EI, elastic.mass_per_length, elastic.loss_factor);
  const model::Model span = clamp_only();
  for (const double frequency : {15.0, 27.0}) {
    const double w = 2 * pi * frequency;
    const auto hung = damper::make_hanging_damper(
        span, {{.arm = both.arms[0], .side = Side::left}, {.arm = both.arms[1], .side = Side::right}}, messenger,
        {.node = 0, .elements = 6, .frequency = frequency});
    const Eigen::Vector2cd motion(1e-3, Complex(-2e-3, 3e-3));  // [m], [rad]
    constexpr int steps = 400, cycles = 120;                    // the beginning dies out at the arms' own frequencies
    Eigen::Vector2cd force = Eigen::Vector2cd::Zero();
    for (int i = 0; i <= cycles * steps; ++i) {
      const double t = i / (frequency * steps);
      const Eigen::Vector2cd now = motion * std::polar(1.0, w * t);
      const Eigen::Vector2cd rate = Complex(0, w) * now, acceleration = -w * w * now;
      const double u[] = {0, now(0).real(), now(1).real()}, v[] = {0, rate(0).real(), rate(1).real()},
                   a[] = {0, acceleration(0).real(), acceleration(1).real()};
      const system::State state{.u = u, .v = v, .a = a};
      double f[3] = {};
      hung->add_force(state, t, f);
      hung->commit(state, t);
      if (i > (cycles - 1) * steps) force += Eigen::Vector2cd(f[1], f[2]) * std::polar(2.0 / steps, -w * t);
    }
    const Eigen::Matrix2cd left = damper::clamp_stiffness(both.arms[0], elastic, w);
    Eigen::Matrix2cd S = damper::clamp_stiffness(both.arms[1], elastic, w);
    S(0, 0) += left(0, 0);
    S(0, 1) -= left(0, 1);
    S(1, 0) -= left(1, 0);
    S(1, 1) += left(1, 1);
    const Eigen::Vector2cd expected = S * motion;
    CHECK(std::abs(force(0) - expected(0)) < 0.01 * std::abs(expected(0)));
    CHECK(std::abs(force(1) - expected(1)) < 0.01 * std::abs(expected(1)));
  }
}
