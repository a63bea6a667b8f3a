// A span in the wind: what locked-in vortices and wakes give, and where the vibration settles.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "solver/vibration.hpp"
#include "strandyn/air/lock_in.hpp"
#include "strandyn/observe/cycles.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using std::numbers::pi;
using test::check_close;
using test::Vibration;

namespace {

constexpr double diameter = 0.0317;

/// A pinned elastic span, whose modes are sines, in the wind that is locked to one of them.
class InWind {
 public:
  InWind(const air::WindPowerCurve& curve, std::size_t mode)
      : vibration(test::stick_law(), {.length = 8, .elements = 24, .clamped = false, .graded = false}, mode),
        wind_{.curve = curve, .diameter = diameter, .turbulence_intensity = 0.05},
        mode_(mode) {
    vibration.model.wind = model::LockedInWind{wind_};
  }

  /// Finds the mode swinging with this antinode amplitude. [m]
  void lock_in(double amplitude) {
    vibration.system.set_wind(
        system::make_locked_in_wind(vibration.model, {.frequency = vibration.mode.frequency,
                                                      .number = mode_,
                                                      .shape = vibration.mode.shape,
                                                      .momentum = momentum(),
                                                      .rest = vibration.rest,
                                                      .velocity = amplitude * vibration.omega()}));
  }

  /// [W] of the curve on the whole span.
  double measured_power(double amplitude) const {
    return 8 * air::wind_power(wind_, {.antinode_amplitude = amplitude, .frequency = vibration.mode.frequency});
  }
  /// [W] mean over a cycle of the mode with this antinode amplitude [m], once it is known.
  double power_in_cycle(double amplitude) {
    lock_in(amplitude);
    double sum = 0;
    constexpr int samples = 64;
    const system::Vector zero = vibration.rest;
    for (int i = 0; i < samples; ++i) {
      const double phase = 2 * pi * i / samples;
      const system::Vector u = amplitude * std::sin(phase) * vibration.mode.shape;
      const system::Vector v = amplitude * vibration.omega() * std::cos(phase) * vibration.mode.shape;
      sum += vibration.system.wind_power({.u = u.data(), .v = v.data(), .a = zero.data()}) / samples;
    }
    return sum;
  }
  /// What the last cycle of a run from an amplitude [m] shows, under viscous damping of the mode.
  observe::Cycle settle(double from, double damping_ratio, int cycles) {
    lock_in(from);
    system::ProportionalDamping damping;
    damping.modes.push_back(
        {.momentum = momentum(), .factor = 2 * damping_ratio * vibration.omega() / vibration.mode.modal_mass});
    vibration.system.set_damping(std::move(damping));
    observe::CycleObserver observer({.period = vibration.period(), .loop_length = 8.0 / static_cast<double>(mode_)});
    observe::Observer* const observers[] = {&observer};
    const auto run = integrate(vibration.system, vibration.start(from), vibration.options(40, cycles),
                               solver::GeneralizedAlpha{.rho_inf = 1}, observers);
    CHECK(run.ending == solver::Ending::finished);
    const observe::Account& a = observer.ledger().now();
    check_close(a.work_in(), a.kinetic + a.elastic - a.initial_kinetic + a.dissipated() + a.numerical(),
                {.relative = 1e-12});
    CHECK(a.wind > 0);
    CHECK(a.external_work == 0);
    return observer.cycles().back();
  }

  Vibration vibration;

 private:
  system::Vector momentum() const {
    system::Matrix M = vibration.system.make_matrix();
    vibration.system.mass_matrix(vibration.rest.data(), M);
    system::Vector product = vibration.rest;
    M.multiply(vibration.mode.shape.data(), product.data());
    return product;
  }

  air::Wind wind_;
  std::size_t mode_;
};

}  // namespace

TEST_CASE("wind: every sine loop is fed what the curve says at any amplitude of its range") {
  for (const air::WindPowerCurve* curve : air::wind_power_curves()) {
    InWind in_wind(*curve, 4);
    for (const double a : {0.06, 0.1, 0.3}) {
      check_close(in_wind.power_in_cycle(a * diameter), in_wind.measured_power(a * diameter), {.relative = 2e-3});
    }
  }
}

TEST_CASE("wind: below its curve a vibration grows at one rate and above it the power stays") {
  InWind in_wind(air::cigre_cubic(), 3);
  const double lowest = air::cigre_cubic().lowest * diameter;
  const double there = in_wind.power_in_cycle(lowest);
  check_close(in_wind.power_in_cycle(1e-3 * lowest), 1e-6 * there, {.relative = 1e-6});
  const double highest = air::brika_laneville().highest * diameter;
  InWind other(air::brika_laneville(), 3);
  check_close(other.power_in_cycle(1.5 * highest), other.power_in_cycle(highest), {.relative = 1e-3});
}

TEST_CASE("wind: what swings at another frequency is fed some hundredths of what the locked mode is") {
  InWind in_wind(air::diana_falco(), 4);
  Vibration& vibration = in_wind.vibration;
  const double amplitude = 0.1 * diameter;
  in_wind.lock_in(amplitude);
  const solver::Mode other = solver::transverse_modes(vibration.system, vibration.rest, 5).back();
  const double own = 2 * pi * other.frequency, step = vibration.period() / 40;
  const system::Vector zero = vibration.rest;
  vibration.system.start_clock(0);
  double fed = 0;
  constexpr int steps = 40 * 60;
  for (int i = 0; i <= steps; ++i) {
    const double t = i * step;
    const system::Vector u =
        amplitude * (std::sin(vibration.omega() * t) * vibration.mode.shape + std::sin(own * t) * other.shape);
    const system::Vector v = amplitude * (vibration.omega() * std::cos(vibration.omega() * t) * vibration.mode.shape +
                                          own * std::cos(own * t) * other.shape);
    const system::State state{.u = u.data(), .v = v.data(), .a = zero.data()};
    vibration.system.commit(state, t);
    if (i < steps / 2) continue;
    system::Vector f = zero;
    vibration.system.add_attached_force(state, t, f.data());
    fed -= f.dot(other.shape) * own * std::cos(own * t) * amplitude * 2 / steps;
  }
  CHECK(std::abs(fed) < 0.06 * in_wind.measured_power(amplitude));
}

TEST_CASE("wind: a damped mode settles where wind and damping balance from below and from above" *
          doctest::test_suite("slow")) {
  // Modal damping takes 2 zeta m omega^3 A^2/4 per metre of a sine.
  const double amplitude = 0.3 * diameter;
  for (const std::size_t mode : {2u, 3u, 4u, 5u, 6u}) {
    CAPTURE(mode);
    InWind below(air::diana_falco(), mode);
    const double mass_per_length = 4 * below.vibration.mode.modal_mass / (2 * 8);
    const double omega = below.vibration.omega();
    const auto damping_of = [&](double a) {
      return below.measured_power(a) / 8 / (mass_per_length * omega * omega * omega * a * a / 2);
    };
    const double zeta = damping_of(amplitude);
    CHECK(damping_of(1.1 * amplitude) < zeta);  // stable
    const int cycles = static_cast<int>(10 / zeta / (2 * pi));
    const observe::Cycle from_below = below.settle(0.7 * amplitude, zeta, cycles);
    check_close(from_below.antinode_amplitude, amplitude, {.relative = 0.02});
    check_close(from_below.wind, from_below.viscous, {.relative = 0.02});
    InWind above(air::diana_falco(), mode);
    check_close(above.settle(1.3 * amplitude, zeta, cycles).antinode_amplitude, amplitude, {.relative = 0.02});
  }
}

namespace {

/// A rigid cylinder on springs across the wind: a stiff free bar of one metre, moved as a whole.
struct OnSprings {
  double mass_ratio = 0;     // [-] mass over that of the air in its place
  double reduced_speed = 0;  // [-] U/(f_n D), f_n with the air that moves along
  double damping_ratio = 0;  // [-]
  math::TimeFunction history = math::Constant{};
};
constexpr double frequency = 5;  // [Hz] f_n
constexpr int cycles_of_run = 60, steps_per_cycle = 400;

model::WakeWind wind_of(const OnSprings& on) {
  model::WakeWind wind;
  wind.wake.diameter = diameter;
  wind.speed = on.reduced_speed * frequency * diameter;
  wind.history = on.history;
  wind.shear = {1, 1};
  return wind;
}

/// [m] the largest displacement in the last ten periods of f_n before each of the times that are looked at.
class Largest final : public observe::Observer {
 public:
  explicit Largest(const std::vector<double>& looks) : looks_(looks), values(looks.size(), 0.0) {}
  void begin(const system::System&, const observe::StepRecord&) override {}
  void step(const system::System& s, const observe::StepRecord& record) override {
    see(record.time, s.model().displacement(record.u.data(), 1).y());
  }
  void see(double time, double y) {
    for (std::size_t i = 0; i < looks_.size(); ++i) {
      if (time > looks_[i] || time < looks_[i] - 10 / frequency) continue;
      values[i] = std::max(values[i], std::abs(y));
    }
  }

 private:
  std::vector<double> looks_;  // [s]

 public:
  std::vector<double> values;
};

/// From rest with q = 2.
std::vector<double> by_chain(const OnSprings& on, const std::vector<double>& looks) {
  const model::WakeWind wind = wind_of(on);
  const double air = wind.wake.mass_of_air();
  const double mass = on.mass_ratio * air;
  const double omega = 2 * pi * frequency;
  model::Model model;
  model.freedom = model::Freedom::planar;
  model::lay_out(model, {.positions = {0, 1}, .strain = 0});
  model.supports = {{.node = 0, .fixed = {true, false, false, false, false, true}},
                    {.node = 1, .fixed = {false, false, false, false, false, true}}};
  model.law = test::linear_law(1e6, 1e4);
  model.inertia = {.mass = mass, .rotary = 0};
  model.mass_matrix = model::MassMatrix::consistent;
  for (const std::size_t node : {std::size_t{0}, std::size_t{1}}) {
    model.bodies.push_back({.node = node,
                            .mass = air / 2,
                            .stiffness = (mass + air) * omega * omega / 2,
                            .damping = (mass + air) * on.damping_ratio * omega});
  }
  model.wind = wind;
  system::System system(model);
  const system::Vector rest = system.make_vector();
  system.begin(rest);
  system.set_wind(system::make_wake_wind(model));
  Largest largest(looks);
  observe::Observer* const observers[] = {&largest};
  const double step = 1 / (frequency * steps_per_cycle);
  const auto run = integrate(system, {.u = rest, .v = rest}, {.step = step, .end_time = looks.back(), .stop = {}},
                             solver::GeneralizedAlpha{.rho_inf = 1}, observers);
  CHECK(run.ending == solver::Ending::finished);
  return largest.values;
}

/// The two equations by themselves, the classical Runge-Kutta method with many steps.
std::vector<double> by_two_equations(const OnSprings& on, const std::vector<double>& looks) {
  const model::WakeWind wind = wind_of(on);
  const air::WakeModel& wake = wind.wake;
  const double m = (on.mass_ratio + 1) * wake.mass_of_air(), omega = 2 * pi * frequency;
  using State = Eigen::Vector4d;  // y, y', q, q'
  const auto rate = [&](double time, const State& s) {
    const double speed = wind.speed * math::evaluate(wind.history, time);
    const double omega_f = 2 * pi * wake.strouhal * speed / wake.diameter;
    const double force = wake.density * speed * speed * wake.diameter * wake.lift / 4 * s(2) -
                         wake.stall * omega_f * wake.density * wake.diameter * wake.diameter * s(1);
    const double a = force / m - 2 * on.damping_ratio * omega * s(1) - omega * omega * s(0);
    return State(s(1), a, s(3),
                 wake.coupling / wake.diameter * a - wake.epsilon * omega_f * (s(2) * s(2) - 1) * s(3) -
                     omega_f * omega_f * s(2));
  };
  State s(0, 0, 2, 0);
  const int steps = 2000;
  const double h = 1 / (frequency * steps);
  Largest largest(looks);
  for (int i = 0; i * h < looks.back(); ++i) {
    const double t = i * h;
    const State k1 = rate(t, s), k2 = rate(t + h / 2, s + h / 2 * k1), k3 = rate(t + h / 2, s + h / 2 * k2),
                k4 = rate(t + h, s + h * k3);
    s += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    largest.see(t + h, s(0));
  }
  return largest.values;
}

std::vector<air::LockedIn> by_one_harmonic(const OnSprings& on, double reduced_speed) {
  const air::WakeModel wake = wind_of(on).wake;
  return air::lock_in(
      wake,
      {.mass = (on.mass_ratio + 1) * wake.mass_of_air(), .frequency = frequency, .damping_ratio = on.damping_ratio},
      reduced_speed * frequency * diameter);
}

}  // namespace

TEST_CASE(
    "wind: a cylinder on springs in its wake is the two coupled equations light and heavy in and out of lock-in") {
  for (const double mass_ratio : {2.0, 20.0, 1600.0}) {
    for (const double reduced_speed : {4.0, 5.0, 5.5, 7.0}) {
      const OnSprings on{.mass_ratio = mass_ratio, .reduced_speed = reduced_speed, .damping_ratio = 1e-3};
      CAPTURE(mass_ratio);
      CAPTURE(reduced_speed);
      const std::vector<double> end = {cycles_of_run / frequency};
      check_close(by_chain(on, end)[0], by_two_equations(on, end)[0], {.relative = 5e-3});
    }
  }
}

TEST_CASE("wind: a wind that rises and falls leads a cylinder along the branches of the two coupled equations" *
          doctest::test_suite("slow")) {
  const std::vector<double> speeds = {4.5, 5, 5.5, 6, 6.5, 7, 8, 7, 6.5, 6, 5.5, 5, 4.5};
  for (const double mass_ratio : {2.0, 20.0, 1600.0}) {
    // From one speed to the next in five periods; then it stands still for fifty.
    OnSprings on{.mass_ratio = mass_ratio, .reduced_speed = 1, .damping_ratio = 1e-3};
    math::Tabulated history;
    std::vector<double> looks;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      for (const double cycles : {55.0 * static_cast<double>(i), 55.0 * static_cast<double>(i) + 50}) {
        history.time.push_back(cycles / frequency);
        history.value.push_back(speeds[i]);
      }
      looks.push_back(history.time.back());
    }
    on.history = history;
    const std::vector<double> chain = by_chain(on, looks), equations = by_two_equations(on, looks);
    std::string table = fmt::format(
        "mass ratio {}: U/(f_n D), amplitude over D of the chain, of the equations, of one "
        "harmonic\n",
        mass_ratio);
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      CAPTURE(mass_ratio);
      CAPTURE(speeds[i]);
      CAPTURE(i);
      check_close(chain[i], equations[i], {.relative = 5e-3});
      table += fmt::format("{:4.1f}  {:.5f}  {:.5f} ", speeds[i], chain[i] / diameter, equations[i] / diameter);
      for (const air::LockedIn& branch : by_one_harmonic(on, speeds[i])) {
        table += fmt::format("  {:.5f} ({:.3f} Hz)", branch.amplitude / diameter, branch.frequency);
      }
      table += "\n";
    }
    MESSAGE(table);
  }
}
