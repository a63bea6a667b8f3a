// Vibrations that die out or settle: the integrator's own damping, friction, drag, seen by the ledger.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "solver/vibration.hpp"
#include "strandyn/exact/tensioned_beam.hpp"
#include "strandyn/observe/cycles.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using strandyn::observe::Account;
using strandyn::observe::Cycle;
using strandyn::observe::CycleObserver;
using strandyn::test::check_close;
using strandyn::test::SpanOptions;
using strandyn::test::Vibration;

namespace {

constexpr double pi = std::numbers::pi;

struct Decay {
  double amplitude = 0;  // [m]
  double steps_per_cycle = 0;
  double cycles = 0;
};

CycleObserver watch(Vibration& vibration, std::size_t mode, const Decay& decay) {
  CycleObserver observer({.period = vibration.period(), .loop_length = 30 / static_cast<double>(mode)});
  observe::Observer* const observers[] = {&observer};
  const auto summary = integrate(vibration.system, vibration.start(decay.amplitude),
                                 vibration.options(decay.steps_per_cycle, decay.cycles), solver::Ida{}, observers);
  CHECK(summary.ending == solver::Ending::finished);
  CHECK(summary.order_one_steps == 0);
  CHECK(observer.cycles().size() == static_cast<std::size_t>(decay.cycles));
  return observer;
}

double energy(const Cycle& c) {
  return c.kinetic + c.elastic;
}

}  // namespace

TEST_CASE("decay: what the integrator takes from a linear mode is 4 pi zeta E per cycle with zeta = (omega h)^3/4") {
  for (const double steps : {100.0, 200.0, 400.0}) {
    Vibration vibration(test::stick_law(), {}, 12);
    const CycleObserver observer = watch(vibration, 12, {.amplitude = 5e-4, .steps_per_cycle = steps, .cycles = 4});
    const auto& cycles = observer.cycles();
    const double theta = 2 * pi / steps;
    for (std::size_t i = 1; i < cycles.size(); ++i) {
      const double mean_energy = 0.5 * (energy(cycles[i - 1]) + energy(cycles[i]));
      const double zeta = cycles[i].numerical / (4 * pi * mean_energy);
      // The next term is of relative size theta^2: measured 1 %, 0.2 %, 0.04 % below.
      check_close(zeta, std::pow(theta, 3) / 4, {.relative = 3 * theta * theta});
      CHECK(cycles[i].friction == 0.0);
      CHECK(cycles[i].elements_slipping == 0);
      // The mode is scaled at its largest node, whichever loop that lies in.
      check_close(cycles[i].antinode_amplitude, 5e-4, {.relative = 0.02});
    }
    // Ledger of a closed system: what was there is there or lost to the integrator.
    const Account& a = observer.ledger().now();
    check_close(a.internal_work, a.elastic, {.absolute = 1e-8 * a.initial_kinetic});
    CHECK(a.external_work == 0.0);
  }
}

TEST_CASE("decay: friction takes the energy of a slipping span, the integrator a small part") {
  Vibration vibration(test::return_map(), {}, 12);
  const CycleObserver observer = watch(vibration, 12, {.amplitude = 1e-2, .steps_per_cycle = 200, .cycles = 5});
  const Account& a = observer.ledger().now();
  // 34 J at the start, 16 J lost to friction in five cycles. Measured: numerical part -1e-4, quadrature error 7e-4 of
  // it.
  CHECK(a.friction > 0.4 * a.initial_kinetic);
  CHECK(std::abs(a.numerical()) < 1e-3 * a.friction);
  CHECK(a.quadrature_error < 1e-3 * a.friction);
  for (std::size_t i = 1; i < observer.cycles().size(); ++i) {
    const Cycle& before = observer.cycles()[i - 1];
    const Cycle& c = observer.cycles()[i];
    CHECK(c.antinode_amplitude < before.antinode_amplitude);
    if (i > 1) CHECK(c.friction < before.friction);  // the first cycle begins with virgin sections
    CHECK(c.elements_slipping > 0);
  }
}

TEST_CASE("decay: below the threshold of slip there is no friction at all and above it the clamps slip first") {
  // Curvature amplitudes at 0.5 mm: 2.3e-3 1/m at the clamps, 8e-4 between; wires slip from 8e-3 on.
  Vibration still(test::return_map(), {}, 12);
  const CycleObserver below = watch(still, 12, {.amplitude = 5e-4, .steps_per_cycle = 100, .cycles = 2});
  CHECK(below.ledger().now().friction == 0.0);
  CHECK(below.cycles().back().elements_slipping == 0);

  Vibration slipping(test::return_map(), {}, 12);
  const CycleObserver above = watch(slipping, 12, {.amplitude = 2e-3, .steps_per_cycle = 100, .cycles = 2});
  CHECK(above.ledger().now().friction > 0);
  const auto profile = above.profile(slipping.system);
  for (std::size_t i = 0; i < profile.position.size(); ++i) {
    const double from_clamp = std::min(profile.position[i], 30 - profile.position[i]);
    if (from_clamp < 0.02) CHECK(profile.friction[i] > 0);
    if (from_clamp > 0.1) CHECK(profile.friction[i] == 0.0);
    if (profile.friction[i] > 0) CHECK(profile.curvature_amplitude[i] > 7.5e-3);
  }
}

TEST_CASE("decay: the second way to the losses differs by an error that falls with the square of the step") {
  const auto mismatch = [](double steps) {
    Vibration vibration(test::return_map(), {}, 12);
    const CycleObserver observer = watch(vibration, 12, {.amplitude = 1e-2, .steps_per_cycle = steps, .cycles = 2});
    const Account& a = observer.ledger().now();
    return (a.internal_work - (a.elastic + a.friction - a.quadrature_error)) / a.friction;
  };
  // Over five cycles, in parts of the friction: 2.0e-5, 5.2e-6, 1.3e-6, 3.3e-7 for N = 100, 200, 400, 800.
  const double coarse = mismatch(100);
  const double fine = mismatch(200);
  CHECK(std::abs(coarse) < 1e-4);
  CHECK(coarse / fine > 3);
  CHECK(coarse / fine < 5);
}

TEST_CASE("decay: drag takes 4 pi zeta E per cycle with zeta = c/(2 m omega)") {
  const double drag = 5;
  Vibration vibration(test::stick_law(), {.drag = drag}, 12);
  const CycleObserver observer = watch(vibration, 12, {.amplitude = 5e-4, .steps_per_cycle = 200, .cycles = 3});
  const double zeta = drag / (2 * test::curlew_mass * vibration.omega());
  const auto& cycles = observer.cycles();
  for (std::size_t i = 1; i < cycles.size(); ++i) {
    // Mean over an exponential: the ratio of two ends is exp(-4 pi zeta).
    const double mean_energy =
        (energy(cycles[i - 1]) - energy(cycles[i])) / std::log(energy(cycles[i - 1]) / energy(cycles[i]));
    check_close(cycles[i].viscous / (4 * pi * mean_energy), zeta, {.relative = 2e-3});
    check_close(cycles[i].antinode_amplitude / cycles[i - 1].antinode_amplitude, std::exp(-2 * pi * zeta),
                {.relative = 1e-3});
  }
}

TEST_CASE("decay: curvatures along the vibrating span are those of the tensioned beam") {
  Vibration vibration(test::stick_law(), {.mass = model::MassMatrix::consistent}, 12);
  const CycleObserver observer = watch(vibration, 12, {.amplitude = 5e-4, .steps_per_cycle = 200, .cycles = 1});
  const auto profile = observer.profile(vibration.system);
  const double EI = conductor::section_constants(test::curlew()).EI_max;
  const exact::TensionedBeamMode mode(
      {.tension = test::curlew_tension, .EI = EI, .mass_per_length = test::curlew_mass, .length = 30},
      exact::BeamEnds::clamped, 12);
  // Largest: 2.3e-3 1/m at the clamps. Measured 9e-7; with lumped mass 3e-5, where neighbours in the middle are of
  // different size.
  for (std::size_t i = 0; i < profile.position.size(); ++i) {
    const double expected = 5e-4 * std::abs(mode.at(profile.position[i]).curvature);
    check_close(profile.curvature_amplitude[i], expected, {.absolute = 2e-6});
  }
}

TEST_CASE("forced vibration: at resonance the force brings in what drag takes, at the amplitude of the textbook") {
  const double drag = 4;
  const SpanOptions span{.length = 10, .elements = 20, .graded = false, .drag = drag};
  Vibration vibration(test::stick_law(), span, 1);
  vibration.model.loads = {
      {.node = 5, .force = {0, 2, 0}, .history = model::Harmonic{.frequency = vibration.mode.frequency}}};
  CycleObserver observer({.period = vibration.period(), .loop_length = 10});
  observe::Observer* const observers[] = {&observer};
  // zeta = 3.3 %: after 60 cycles exp(-2 pi zeta 60) = 4e-6 of the start is left.
  integrate(vibration.system, {.u = vibration.rest, .v = vibration.rest}, vibration.options(200, 60), solver::Ida{},
            observers);
  const Cycle& last = observer.cycles().back();
  check_close(last.external_work, last.viscous + last.numerical, {.relative = 1e-4});
  CHECK(std::abs(last.numerical) < 1e-3 * last.viscous);
  // Force on the mode over its drag: A = F phi(x)/(omega c_mode), c_mode = c m_mode/m; the mode's shift by the step,
  // theta^2/3 = 3e-4 against zeta = 3e-2, costs 5e-5.
  const double share = vibration.mode.shape(16);
  const double modal_drag = drag * vibration.mode.modal_mass / test::curlew_mass;
  check_close(last.antinode_amplitude, 2 * std::abs(share) / (vibration.omega() * modal_drag), {.relative = 2e-3});
}

TEST_CASE("decay: the friction of a decay converges with the step while the numerical part vanishes") {
  // Over five cycles from 5 mm. Measured for N = 100, 200, 400, 800: numerical part 3.1e-2, 3.6e-3, 3.4e-4, -5e-6 of
  // the friction (the quadrature error is in it with a minus), friction 0.9857, 0.9940, 0.9980, 0.9982 J.
  const auto account = [](double steps) {
    Vibration vibration(test::return_map(), {}, 12);
    return watch(vibration, 12, {.amplitude = 5e-3, .steps_per_cycle = steps, .cycles = 5}).ledger().now();
  };
  const Account coarse = account(100);
  const Account middle = account(200);
  const Account fine = account(800);
  CHECK(coarse.numerical() < 0.05 * coarse.friction);
  CHECK(middle.numerical() < 0.2 * coarse.numerical());
  CHECK(std::abs(fine.numerical()) < 1e-4 * fine.friction);
  check_close(middle.friction, fine.friction, {.relative = 0.01});
}

TEST_CASE("decay: still air takes the energy of a linear mode by zeta = c/(2 m omega)") {
  // By steps without damping of their own, from the energies alone: two hundred cycles lose 3.6 %.
  Vibration vibration(test::stick_law(), {.length = 3, .elements = 24, .clamped = false, .graded = false}, 1);
  vibration.model.surroundings = {.air = {}, .diameter = 0.0317};
  vibration.system.set_swing(vibration.mode.frequency);
  CycleObserver observer({.period = vibration.period(), .loop_length = 3});
  observe::Observer* const observers[] = {&observer};
  constexpr int cycles = 200;
  const auto summary = integrate(vibration.system, vibration.start(1e-4), vibration.options(100, cycles),
                                 solver::GeneralizedAlpha{.rho_inf = 1}, observers);
  CHECK(summary.ending == solver::Ending::finished);
  const Account& a = observer.ledger().now();
  const double left = a.kinetic + a.elastic;
  const double c = air::attached_flow({}, 0.0317, vibration.mode.frequency);
  const double mass = vibration.model.inertia.mass;  // per unstressed length, as the air's force
  check_close(std::log(a.initial_kinetic / left) / (4 * pi * cycles), c / (2 * mass * vibration.omega()),
              {.relative = 5e-3});
  check_close(a.air, a.initial_kinetic - left, {.relative = 2e-3});
  CHECK(a.friction == 0.0);
  CHECK(a.viscous.total() == 0.0);
  for (const Cycle& cycle : observer.cycles()) CHECK(cycle.air > 0);
}

TEST_CASE("decay: the metal takes eta of the bending energy, friction and air beside it") {
  const auto branches = section::branches_of(section::material_loss({0, 0, 2400, 2400}, 2e-3));
  Vibration vibration(test::return_map(), {.length = 10, .elements = 30, .material = branches}, 4);
  vibration.model.surroundings = {.air = {}, .diameter = 0.0317};
  vibration.system.set_swing(vibration.mode.frequency);
  CycleObserver observer({.period = vibration.period(), .loop_length = 2.5});
  observe::Observer* const observers[] = {&observer};
  integrate(vibration.system, vibration.start(5e-3), vibration.options(200, 5), solver::Ida{}, observers);
  const Account& a = observer.ledger().now();
  CHECK(a.friction > 0);
  CHECK(a.material > 0);
  CHECK(a.air > 0);
  // The second way to what the sections store and lose, over both the law and the branches.
  check_close(a.internal_work, a.elastic + a.friction + a.material - a.quadrature_error,
              {.absolute = 2e-4 * a.initial_kinetic});
  CHECK(std::abs(a.numerical()) < 5e-3 * a.dissipated());
  const observe::Profile profile = observer.profile(vibration.system);
  double by_place = 0;
  for (std::size_t p = 0; p < profile.material.size(); ++p) {
    by_place += profile.material[p] * vibration.system.point_length(p);
  }
  check_close(by_place, a.material / 5, {.relative = 1e-9});
}
