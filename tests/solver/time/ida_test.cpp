#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <regex>
#include <stdexcept>

#include "solver/vibration.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/solver/time/integrator.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using strandyn::observe::StepRecord;
using strandyn::solver::Ending;
using strandyn::solver::Ida;
using strandyn::solver::integrate;
using strandyn::solver::IntegratorOptions;
using strandyn::solver::IntegratorSummary;
using strandyn::system::System;
using strandyn::system::Vector;
using strandyn::test::check_close;
using strandyn::test::SpanOptions;
using strandyn::test::Vibration;

namespace {

/// Keeps times, orders, the mode's coordinate and energies of a run.
class Recorder final : public observe::Observer {
 public:
  explicit Recorder(const Vibration& vibration) : vibration_(vibration) {}
  void begin(const System& system, const StepRecord& initial) override { step(system, initial); }
  void step(const System& system, const StepRecord& record) override {
    time.push_back(record.time);
    steps.push_back(record.step);
    order.push_back(record.order);
    coordinate.push_back(vibration_.coordinate(record.u));
    energy.push_back(record.accepted.elastic + system.kinetic_energy(record.u.data(), record.v.data()));
    friction += record.accepted.friction;
    u = record.u;
  }

  std::vector<double> time, steps, coordinate, energy;
  std::vector<int> order;
  double friction = 0;
  Vector u;

 private:
  const Vibration& vibration_;
};

IntegratorSummary run(Vibration& vibration, double amplitude, const IntegratorOptions& options, Recorder& recorder) {
  observe::Observer* const observers[] = {&recorder};
  return integrate(vibration.system, vibration.start(amplitude), options, Ida{}, observers);
}

/// [Hz] from the first to the last upward crossing of zero, found between steps by a straight line.
double measured_frequency(const Recorder& r) {
  std::vector<double> crossings;
  for (std::size_t i = 1; i < r.time.size(); ++i) {
    const double before = r.coordinate[i - 1];
    const double after = r.coordinate[i];
    if (!(before < 0 && after >= 0)) continue;
    crossings.push_back(r.time[i - 1] - before / (after - before) * (r.time[i] - r.time[i - 1]));
  }
  return static_cast<double>(crossings.size() - 1) / (crossings.back() - crossings.front());
}

/// A linear law that throws when it has been asked often enough.
class FailingLaw final : public section::Law {
 public:
  explicit FailingLaw(int calls) : inner_(test::stick_law()), left_(calls) {}
  std::string_view name() const override { return "failing"; }
  section::Dimension dimension() const override { return inner_->dimension(); }
  section::History start(const section::Field& strains) const override { return inner_->start(strains); }
  section::Effort respond(const section::History& history, const section::Field& strains, section::Field& stresses,
                          section::TangentField* tangents) const override {
    if (--left_ < 0) throw std::domain_error("the law has had enough");
    return inner_->respond(history, strains, stresses, tangents);
  }
  section::Effort commit(section::History& history, const section::Field& strains,
                         section::StepEnergy& energy) const override {
    return inner_->commit(history, strains, energy);
  }

 private:
  test::LawPointer inner_;
  mutable int left_;
};

}  // namespace

TEST_CASE("ida: the frequency of a mode is too low by (omega h)^2/3") {
  Vibration vibration(test::stick_law(), {}, 12);
  for (const double steps : {50.0, 100.0}) {
    Recorder recorder(vibration);
    // Small enough that the swing's own tension, of fourth power in the amplitude, does not show.
    run(vibration, 5e-5, vibration.options(steps, 12), recorder);
    const double theta = 2 * std::numbers::pi / steps;
    const double error = measured_frequency(recorder) / vibration.mode.frequency - 1;
    check_close(error, -theta * theta / 3, {.relative = 0.05});  // the next term is theta^4
  }
}

TEST_CASE("ida: the energy of a mode decays as zeta = (omega h)^3/4, lumped and consistent") {
  for (const auto mass : {model::MassMatrix::lumped, model::MassMatrix::consistent}) {
    Vibration vibration(test::stick_law(), {.mass = mass}, 12);
    const double steps = 100;
    Recorder recorder(vibration);
    run(vibration, 5e-4, vibration.options(steps, 11), recorder);
    const double still = vibration.system.commit(vibration.rest.data()).elastic;
    const auto per_cycle = static_cast<std::size_t>(steps);
    const std::size_t last = recorder.energy.size() - 1;
    const double ratio = (recorder.energy[last - 10 * per_cycle] - still) / (recorder.energy[last] - still);
    const double zeta = std::log(ratio) / (4 * std::numbers::pi * 10);
    check_close(zeta, std::pow(2 * std::numbers::pi / steps, 3) / 4, {.relative = 0.02});
  }
}

TEST_CASE("ida: steps meet the ends of the cycles and stay at order two after the start") {
  Vibration vibration(test::return_map(), {}, 12);
  Recorder recorder(vibration);
  const IntegratorSummary summary = run(vibration, 2e-3, vibration.options(200, 3), recorder);
  CHECK(summary.ending == Ending::finished);
  CHECK(summary.order_one_steps == 0);
  CHECK(summary.rejected_steps == 0);
  CHECK(recorder.friction > 0);
  CHECK(summary.steps == 8 + 600);  // nine steps to begin with instead of one
  for (int cycle = 1; cycle <= 3; ++cycle) {
    const double end = cycle * vibration.period();
    const bool met = std::any_of(recorder.time.begin(), recorder.time.end(),
                                 [&](double t) { return std::abs(t - end) <= 1e-9 * vibration.period(); });
    CHECK(met);
  }
  for (std::size_t i = 3; i < recorder.order.size(); ++i) CHECK(recorder.order[i] == 2);
  check_close(summary.end_time, 3 * vibration.period(), {.relative = 1e-9});
  CHECK(summary.newton_iterations >= summary.steps);
}

TEST_CASE("ida: the time between records is the step they tell") {
  Vibration vibration(test::stick_law(), {.elements = 20}, 3);
  Recorder recorder(vibration);
  run(vibration, 1e-3, vibration.options(40, 2), recorder);
  CHECK(recorder.steps.front() == 0.0);
  for (std::size_t i = 1; i < recorder.time.size(); ++i) {
    check_close(recorder.time[i] - recorder.time[i - 1], recorder.steps[i], {.relative = 1e-9});
    CHECK(recorder.steps[i] <= vibration.period() / 40 * (1 + 1e-12));
  }
}

TEST_CASE("ida: laws without friction dissipate nothing at all") {
  for (const auto& law : {test::stick_law(), test::slip_law()}) {
    Vibration vibration(law, {}, 12);
    Recorder recorder(vibration);
    run(vibration, 5e-3, vibration.options(50, 2), recorder);
    CHECK(recorder.friction == 0.0);
  }
}

TEST_CASE("ida: the same run gives the same bits") {
  const auto end_of_run = [] {
    Vibration vibration(test::return_map(), {.elements = 40}, 6);
    Recorder recorder(vibration);
    run(vibration, 5e-3, vibration.options(100, 2), recorder);
    return recorder.u;
  };
  CHECK(end_of_run() == end_of_run());
}

TEST_CASE("ida: a harmonic force drives the span at its own frequency from rest") {
  // Far below the first mode the span follows the force as if at rest.
  Vibration vibration(test::stick_law(), {.length = 10, .elements = 20}, 1);
  const double frequency = vibration.mode.frequency / 50;
  vibration.model.loads = {{.node = 10, .force = {0, 10, 0}, .history = model::Harmonic{.frequency = frequency}}};
  System system(vibration.model);
  system.begin(vibration.rest);
  Vector deflected = vibration.rest;
  {
    system::Matrix K = system.make_matrix();
    Vector force(deflected.size());
    system.internal_force(deflected.data(), force.data(), K);
    system.hold(K);
    math::ChainFactors factors;
    REQUIRE(factors.factorize(K));
    deflected(31) = 10;
    factors.solve(deflected.data());
  }
  Recorder recorder(vibration);
  observe::Observer* const observers[] = {&recorder};
  // A quarter of a period: the force is at its peak.
  integrate(system, {.u = vibration.rest, .v = vibration.rest},
            {.step = 1 / (frequency * 4000), .end_time = 0.25 / frequency, .stop = {}}, Ida{}, observers);
  // The start from rest leaves a swing of (f/f_1) of the static deflection, damped by the coarse step.
  check_close(recorder.u(31), deflected(31), {.relative = 0.03});
}

TEST_CASE("ida: the run ends when it is told to") {
  Vibration vibration(test::stick_law(), {.elements = 20}, 3);
  Recorder recorder(vibration);
  IntegratorOptions options = vibration.options(100, 5);
  int asked = 0;
  options.stop = [&] { return ++asked == 42; };
  const IntegratorSummary summary = run(vibration, 1e-3, options, recorder);
  CHECK(summary.ending == Ending::stopped);
  CHECK(summary.steps == 42);
  CHECK(recorder.time.size() == 43);
  CHECK(summary.end_time == recorder.time.back());
}

TEST_CASE("ida: a step that cannot converge names its time and the worst nodes") {
  Vibration vibration(test::return_map(), {.elements = 20}, 3);
  Recorder recorder(vibration);
  IntegratorOptions options = vibration.options(100, 5);
  options.newton_tolerance = 1e-30;  // below rounding
  const IntegratorSummary summary = run(vibration, 5e-3, options, recorder);
  CHECK(summary.ending == Ending::failed);
  CHECK(summary.rejected_steps > 0);
  INFO(summary.failure);
  CHECK(std::regex_search(summary.failure, std::regex("the step at t = [0-9.e+-]+ s did not converge")));
  CHECK(std::regex_search(summary.failure, std::regex("node [0-9]+ (rotation z|displacement [xy]) \\([0-9.e+-]+\\)")));
  CHECK(summary.failure.find("steps_per_cycle") != std::string::npos);
}

TEST_CASE("ida: an exception of the law comes out as it was thrown") {
  Vibration vibration(std::make_shared<FailingLaw>(300), {.elements = 20}, 3);
  Recorder recorder(vibration);
  CHECK_THROWS_WITH_AS(run(vibration, 1e-3, vibration.options(100, 5), recorder), "the law has had enough",
                       std::domain_error);
}
