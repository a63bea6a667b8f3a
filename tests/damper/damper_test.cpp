// A Stockbridge damper at its clamp: frequencies and impedance against closed forms, energy, chain against two
// unknowns.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "damper/dampers.hpp"
#include "strandyn/damper/arm_chain.hpp"
#include "strandyn/damper/reduced_arm.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using damper::Arm;
using damper::ArmAnswer;
using damper::ArmChain;
using damper::BendingLoops;
using damper::Complex;
using damper::Messenger;
using damper::ReducedArm;
using damper::Shake;
using std::numbers::pi;
using test::check_close;

namespace {

/// [N] on a massless cubic element with a rigid weight at its end, under a displacement Y of the other: two unknowns.
Complex hermite_force(const Arm& arm, Complex EI, double omega, double Y) {
  const double l = arm.length, e = arm.weight.eccentricity, m = arm.weight.mass;
  Eigen::Matrix4cd K;
  K << 12, 6 * l, -12, 6 * l, 6 * l, 4 * l * l, -6 * l, 2 * l * l, -12, -6 * l, 12, -6 * l, 6 * l, 2 * l * l, -6 * l,
      4 * l * l;
  K *= EI / (l * l * l);
  Eigen::Matrix2cd dynamic = K.bottomRightCorner<2, 2>();
  Eigen::Matrix2d M;
  M << m, -m * e, -m * e, arm.weight.inertia + m * e * e;
  dynamic -= omega * omega * M;
  const Eigen::Vector2cd x = dynamic.partialPivLu().solve(-Y * K.block<2, 1>(2, 0));
  return K(0, 0) * Y + (K.block<1, 2>(0, 2) * x)(0);
}

/// [Hz] and [W] of the largest power between two frequencies.
struct Peak {
  double frequency = 0, power = 0;
};
template <class AnyArm>
Peak highest(AnyArm& arm, double from, double to, double velocity) {
  Peak peak;
  constexpr int steps = 60;
  for (int i = 0; i <= steps; ++i) {
    const double frequency = from * std::pow(to / from, static_cast<double>(i) / steps);
    const ArmAnswer answer = arm.answer({.frequency = frequency, .velocity = velocity});
    REQUIRE_MESSAGE(answer.converged, answer.failure);
    if (answer.power() > peak.power) peak = {.frequency = frequency, .power = answer.power()};
  }
  return peak;
}

}  // namespace

TEST_CASE("damper: held at the clamp, both dampers have the eight frequencies of the exact beam") {
  for (const test::Stockbridge& d : test::stockbridges()) {
    const Messenger messenger = test::elastic_messenger(d.EI, d.mass_per_length, 0);
    for (std::size_t a = 0; a < 2; ++a) {
      const std::vector<double> got = ArmChain(d.arms[a], messenger).natural_frequencies(2);
      for (std::size_t k = 0; k < 2; ++k) check_close(got[k], d.frequencies[2 * a + k], {.relative = 1e-5});
    }
  }
}

TEST_CASE("damper: with a massless messenger of loss factor 0.1 the impedance is that of two Hermite arms") {
  for (const test::Stockbridge& d : test::stockbridges()) {
    const Messenger messenger = test::elastic_messenger(d.EI, 0, 0.1);
    const BendingLoops loops(*messenger.law);
    std::array<ArmChain, 2> chains = {ArmChain(d.arms[0], messenger), ArmChain(d.arms[1], messenger)};
    std::array<ReducedArm, 2> reduced = {ReducedArm(d.arms[0], messenger, loops),
                                         ReducedArm(d.arms[1], messenger, loops)};
    for (double frequency = 5; frequency <= 100; frequency *= 1.09) {
      const Shake shake{.frequency = frequency, .velocity = 1e-3};
      Complex exact = 0, by_chain = 0, by_two = 0;
      for (std::size_t a = 0; a < 2; ++a) {
        exact += hermite_force(d.arms[a], d.EI * Complex{1, 0.1}, shake.omega(), shake.displacement()) / Complex{0, 1};
        const ArmAnswer answer = chains[a].answer(shake);
        REQUIRE_MESSAGE(answer.converged, answer.failure);
        by_chain += answer.force;
        by_two += reduced[a].answer(shake).force;
      }
      check_close(std::abs(by_chain - exact) / std::abs(exact), 0, {.absolute = 5e-3}, "chain");
      check_close(std::abs(by_two - exact) / std::abs(exact), 0, {.absolute = 1e-7}, "two unknowns");
    }
  }
}

TEST_CASE("damper: the loops of a section are the describing function of its springs") {
  section::MultilinearSection own{.EA = 1, .GJ = 0, .EI = 2, .springs = {{.stiffness = 3, .yield = 0.1}}};
  const section::MultilinearLaw law(std::move(own), section::Dimension::planar);
  const BendingLoops loops(law, {.smallest = 1e-3, .largest = 10, .per_decade = 400, .samples = 512});
  for (const double c : {0.05, 0.11, 0.2, 0.7, 5.0}) {
    // A spring of stiffness k that yields at y, under c cos(wt).
    const double theta = c > 0.1 ? std::acos(1 - 0.2 / c) : pi;
    const double storage = 2 + 3 / pi * (theta - std::sin(2 * theta) / 2);
    const double loss = c > 0.1 ? 4 * 3 * 0.1 * (c - 0.1) / (pi * c * c) : 0;
    check_close(loops.stiffness(c).real(), storage, {.relative = 3e-4}, "storage");
    check_close(loops.stiffness(c).imag(), loss, {.relative = 3e-3, .absolute = 1e-12}, "loss");
  }
}

TEST_CASE("damper: what the clamp feeds is what the loops of the messenger take, and nothing is lost elastically") {
  const Arm& arm = test::stockbridges()[0].arms[0];
  ArmChain chain(arm, test::slipping_messenger(), {.samples = 128});
  for (const double frequency : {8.0, 10.0, 12.0, 14.0, 30.0, 36.0}) {
    const ArmAnswer answer = chain.answer({.frequency = frequency, .velocity = 0.05});
    REQUIRE_MESSAGE(answer.converged, answer.failure);
    CHECK(answer.friction > 0);
    check_close(answer.power() / frequency, answer.friction, {.relative = 1e-2});
  }
  const Messenger elastic = test::elastic_messenger(4.903, 0.768, 0);
  const ArmAnswer free = ArmChain(arm, elastic).answer({.frequency = 9, .velocity = 0.05});
  CHECK(std::abs(free.force.real()) < 1e-6 * std::abs(free.force));
}

TEST_CASE("damper: slip brings both resonances of an arm down as the clamp moves faster") {
  const Arm& arm = test::stockbridges()[0].arms[0];
  const Messenger messenger = test::slipping_messenger();
  const BendingLoops loops(*messenger.law);
  Peak before[2] = {{.frequency = 11.26}, {.frequency = 38.11}};
  for (const double velocity : {0.01, 0.05, 0.2}) {
    const double windows[2][2] = {{6.5, 12}, {22, 42}};
    for (int k = 0; k < 2; ++k) {
      ArmChain chain(arm, messenger);
      ReducedArm reduced(arm, messenger, loops);
      const Peak full = highest(chain, windows[k][0], windows[k][1], velocity);
      const Peak two = highest(reduced, windows[k][0], windows[k][1], velocity);
      CHECK(full.frequency < before[k].frequency);
      check_close(two.frequency, full.frequency, {.relative = 0.02});
      check_close(two.power, full.power, {.relative = 0.1});
      before[k] = full;
    }
  }
}
