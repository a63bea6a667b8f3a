#include "solver/time/integrator_battery.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <regex>
#include <stdexcept>

#include "support/check_close.hpp"

namespace strandyn::test {

using model::Freedom;
using observe::Observer;
using observe::StepRecord;
using solver::Ending;
using solver::InitialMotion;
using solver::IntegratorOptions;
using solver::IntegratorSummary;
using system::System;
using system::Vector;

namespace {

Integrator through(const solver::TimeMethod& method) {
  return [method](System& system, const InitialMotion& initial, const IntegratorOptions& options,
                  std::span<Observer* const> observers) {
    return solver::integrate(system, initial, options, method, observers);
  };
}

}  // namespace

Integrator ida() {
  return through(solver::Ida{});
}

Integrator generalized_alpha(double rho_inf) {
  return through(solver::GeneralizedAlpha{.rho_inf = rho_inf});
}

void Trace::step(const System& system, const StepRecord& record) {
  time.push_back(record.time);
  steps.push_back(record.step);
  order.push_back(record.order);
  u.push_back(record.u);
  v.push_back(record.v);
  energy.push_back(record.accepted.elastic + system.kinetic_energy(record.u.data(), record.v.data()));
  friction += record.accepted.friction;
  if (also) also(system, record);
}

namespace {

/// A linear law that throws when it has been asked often enough.
class FailingLaw final : public section::Law {
 public:
  explicit FailingLaw(int calls) : inner_(stick_law()), left_(calls) {}
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
  LawPointer inner_;
  mutable int left_;
};

/// A chain that starts from its reference configuration with given velocities, as often as asked.
struct Scene {
  std::string name;
  model::Model model;
  Vector v;
  double duration = 0;  // [s]
  int steps = 0;        // of the coarsest run
};

/// Four elements without axial modes: every mode is resolved, so the order shows at moderate steps.
model::Model coarse_span(double drag, model::MassMatrix mass) {
  return curlew_span(stick_law(), {.length = 10,
                                   .elements = 4,
                                   .graded = false,
                                   .mass = mass,
                                   .drag = drag,
                                   .freedom = Freedom::transverse_planar});
}

Vector first_mode_velocity(const model::Model& model, double amplitude) {
  Vector v = zeros(model);
  for (std::size_t node = 1; node + 1 < model.nodes.size(); ++node) {
    const double x = static_cast<double>(node) / static_cast<double>(model.nodes.size() - 1);
    if (const auto i = model.index(node, model::Unknown::y)) {
      v(static_cast<Eigen::Index>(*i)) = amplitude * 35 * std::sin(std::numbers::pi * x);  // 35/s: about the first mode
    }
  }
  return v;
}

/// Two soft elements in space that tumble, bend and stretch: gyroscopic terms, mass that depends on position.
model::Model tumbling_beam(model::MassMatrix mass) {
  model::Model model;
  model.freedom = Freedom::spatial;
  model::lay_out(model, {.positions = {0, 0.5, 1}, .strain = 0});
  model.law = std::make_shared<section::LinearLaw>("soft", section::Dimension::spatial,
                                                   section::LinearStiffness{.EA = 200, .GJ = 4, .C_AT = 0, .EI = 10});
  model.inertia = {.mass = 1, .rotary = 0.05, .polar = 0.1};
  model.mass_matrix = mass;
  return model;
}

std::vector<Scene> smooth_scenes() {
  using enum model::MassMatrix;
  std::vector<Scene> scenes;
  const auto add = [&](const char* name, model::Model model, Vector v, double duration, int steps) {
    scenes.push_back(
        {.name = name, .model = std::move(model), .v = std::move(v), .duration = duration, .steps = steps});
  };
  for (const auto mass : {lumped, consistent}) {
    const int steps = mass == lumped ? 160 : 1280;  // rotations with mass are fast
    const model::Model still = coarse_span(0, mass);
    add("small swing", still, first_mode_velocity(still, 1e-4), 0.2, steps);
    add("large swing", still, first_mode_velocity(still, 0.1), 0.2, steps);
    const model::Model damped = coarse_span(30, mass);
    add("drag", damped, first_mode_velocity(damped, 0.1), 0.2, steps);

    model::Model shaken = coarse_span(0, mass);
    shaken.motions = {{.node = 0, .unknown = model::Unknown::y, .amplitude = 0.02, .history = model::Harmonic{5}}};
    Vector v = first_mode_velocity(shaken, 0.02);
    v(0) = 0.02 * 2 * std::numbers::pi * 5;
    add("moving support", shaken, v, 0.2, steps);

    const model::Model free = tumbling_beam(mass);
    Vector tumble = zeros(free);
    for (Eigen::Index i = 0; i < tumble.size(); ++i) tumble(i) = std::sin(static_cast<double>(i * i));
    add("tumbling beam", free, tumble, 1, 800);
  }
  model::Model kicked = coarse_span(0, lumped);
  kicked.loads = {{.node = 2,
                   .force = {0, 2000, 0},
                   .history = model::Tabulated{.time = {0, 0.0531, 0.0777, 0.1}, .value = {0, 1, -0.5, 0}}}};
  add("corners of a load", kicked, zeros(kicked), 0.2, 160);
  return scenes;
}

Trace run(const Integrator& integrator, const Scene& scene, int steps) {
  System system(scene.model);
  const Vector u = zeros(scene.model);
  system.begin(u);
  Trace trace;
  Observer* const observers[] = {&trace};
  const IntegratorSummary summary = integrator(
      system, {.u = u, .v = scene.v},
      {.step = scene.duration / steps, .end_time = scene.duration, .newton_tolerance = 1e-13, .stop = {}}, observers);
  REQUIRE_MESSAGE(summary.ending == Ending::finished, summary.failure);
  return trace;
}

void check_ratio(const std::vector<Vector>& ends, double within, const char* what) {
  const double ratio = (ends[0] - ends[1]).norm() / (ends[1] - ends[2]).norm();
  check_close(std::log2(ratio), 2, {.absolute = within}, what);
}

}  // namespace

void check_order(const Integrator& integrator, double within) {
  for (const Scene& scene : smooth_scenes()) {
    CAPTURE(scene.name);
    CAPTURE(static_cast<int>(scene.model.mass_matrix));
    std::vector<Vector> u, v;
    for (const int finer : {1, 2, 4}) {
      const Trace trace = run(integrator, scene, finer * scene.steps);
      u.push_back(trace.u.back());
      v.push_back(trace.v.back());
    }
    check_ratio(u, within, "displacements");
    check_ratio(v, within, "velocities");
  }
}

void check_time(const Integrator& integrator) {
  const auto scene = smooth_scenes().back();  // its corners lie beside the steps
  const int steps = 40;
  const double h = scene.duration / steps;
  const Trace trace = run(integrator, scene, steps);
  CHECK(trace.time.front() == 0.0);
  CHECK(trace.steps.front() == 0.0);
  CHECK(trace.order.front() == 0);
  CHECK(trace.u.front() == zeros(scene.model));
  for (std::size_t i = 1; i < trace.time.size(); ++i) {
    check_close(trace.time[i] - trace.time[i - 1], trace.steps[i], {.relative = 1e-9});
    CHECK(trace.steps[i] <= h * (1 + 1e-9));
  }
  check_close(trace.time.back(), scene.duration, {.relative = 1e-12});
  const auto met = [&](double t) {
    return std::any_of(trace.time.begin(), trace.time.end(), [&](double s) { return std::abs(s - t) <= 1e-9 * h; });
  };
  for (double corner : {0.0531, 0.0777, 0.1}) CHECK(met(corner));

  const Scene smooth = smooth_scenes().front();
  const Trace whole = run(integrator, smooth, steps);
  for (int cycle = 1; cycle <= 4; ++cycle) {
    const double end = cycle * 10 * h;
    CHECK(std::any_of(whole.time.begin(), whole.time.end(), [&](double t) { return std::abs(t - end) <= 1e-9 * h; }));
  }
}

void check_balance(const Integrator& integrator) {
  const auto decay = [&](const LawPointer& law, double amplitude, Trace& trace) {
    Vibration vibration(law, {.length = 10, .elements = 20}, 4);
    Observer* const observers[] = {&trace};
    const auto summary = integrator(vibration.system, vibration.start(amplitude), vibration.options(200, 3), observers);
    REQUIRE_MESSAGE(summary.ending == Ending::finished, summary.failure);
    return vibration.system.kinetic_energy(vibration.rest.data(), vibration.start(amplitude).v.data());
  };
  for (const LawPointer& law : {stick_law(), slip_law()}) {
    Trace trace;
    decay(law, 2e-3, trace);
    CHECK(trace.friction == 0.0);
  }
  Trace trace;
  const double started = decay(return_map(), 5e-3, trace);
  CHECK(trace.friction > 0.05 * started);
  CHECK(std::abs(trace.loss()) <= 5e-3 * trace.friction);  // measured below
}

void check_held(const Integrator& integrator) {
  const double frequency = 5;  // [Hz]
  for (const auto mass : {model::MassMatrix::lumped, model::MassMatrix::consistent}) {
    Scene scene{.name = "moving supports", .model = coarse_span(0, mass), .v = {}, .duration = 0.2, .steps = 1000};
    scene.model.motions = {
        {.node = 0, .unknown = model::Unknown::y, .amplitude = 0.02, .history = model::Harmonic{frequency}}};
    scene.v = zeros(scene.model);
    const Trace trace = run(integrator, scene, scene.steps);
    const auto last = static_cast<Eigen::Index>(*scene.model.index(4, model::Unknown::y));
    for (std::size_t i = 0; i < trace.time.size(); ++i) {
      const double phase = 2 * std::numbers::pi * frequency * trace.time[i];
      check_close(trace.u[i](0), 0.02 * std::sin(phase), {.absolute = 1e-15});
      check_close(trace.v[i](0), 0.02 * 2 * std::numbers::pi * frequency * std::cos(phase), {.absolute = 1e-13});
      CHECK(trace.u[i](last) == 0.0);
    }
    CHECK(trace.u.back().norm() > 0.01);  // the chain has followed
    // Consistent mass feels the support's acceleration too. One per cent is what the coarser run may err.
    const Vector finer = run(ida(), scene, 4 * scene.steps).u.back();
    check_close((trace.u.back() - finer).norm() / finer.norm(), 0, {.absolute = 1e-2});
  }
}

void check_drives(const Integrator& integrator) {
  const model::Drive drives[] = {{.frequency = 5}, {.frequency = 8, .phase = 0.4}};
  const auto shaken = [&](const model::TimeFunction& motion, const model::TimeFunction& load,
                          std::vector<model::Drive> of_the_run) {
    model::Model model = coarse_span(0, model::MassMatrix::consistent);
    model.motions = {{.node = 0, .unknown = model::Unknown::y, .amplitude = 0.02, .history = motion}};
    model.loads = {{.node = 2, .force = {0, 50, 0}, .history = load}};
    System system(model);
    const Vector rest = zeros(model);
    system.begin(rest);
    Trace trace;
    Observer* const observers[] = {&trace};
    integrator(system, {.u = rest, .v = rest}, {.step = 1e-3, .end_time = 0.1, .drives = std::move(of_the_run)},
               observers);
    return trace;
  };
  const auto harmonic = [](const model::Drive& d) {
    return model::Harmonic{.frequency = d.frequency, .phase = d.phase};
  };
  const Trace fixed = shaken(harmonic(drives[0]), harmonic(drives[1]), {});
  const Trace driven = shaken(model::Driven{.drive = 0}, model::Driven{.drive = 1}, {drives[0], drives[1]});
  CHECK(fixed.time == driven.time);
  CHECK(fixed.u == driven.u);
  CHECK(fixed.v == driven.v);
  CHECK(fixed.u.back().norm() > 1e-3);
  const Trace still = shaken(model::Driven{.drive = 0}, model::Driven{.drive = 1}, {});
  CHECK(still.u.back().norm() == 0.0);
}

void check_endings(const Integrator& integrator) {
  const auto decay = [&](const LawPointer& law, const auto& change, Trace& trace) {
    Vibration vibration(law, {.length = 10, .elements = 12}, 2);
    IntegratorOptions options = vibration.options(100, 2);
    change(options);
    Observer* const observers[] = {&trace};
    return integrator(vibration.system, vibration.start(1e-2), options, observers);
  };
  Trace first, again;
  decay(
      return_map(), [](auto&) {}, first);
  decay(
      return_map(), [](auto&) {}, again);
  CHECK(first.u == again.u);
  CHECK(first.v == again.v);

  Trace stopped;
  int asked = 0;
  const auto stop = [&asked] { return ++asked == 42; };
  const auto told = decay(
      stick_law(), [&](IntegratorOptions& o) { o.stop = stop; }, stopped);
  CHECK(told.ending == Ending::stopped);
  CHECK(told.steps == 42);
  CHECK(stopped.time.size() == 43);
  CHECK(told.end_time == stopped.time.back());

  Trace failed;
  const auto stuck = decay(
      return_map(), [](auto& o) { o.newton_tolerance = 1e-30; }, failed);  // below rounding
  CHECK(stuck.ending == Ending::failed);
  CHECK(stuck.rejected_steps > 0);
  INFO(stuck.failure);
  CHECK(std::regex_search(stuck.failure, std::regex("the step at t = [0-9.e+-]+ s did not converge")));
  CHECK(std::regex_search(stuck.failure, std::regex("node [0-9]+ (rotation z|displacement [xy]) \\([0-9.e+-]+\\)")));
  CHECK(stuck.failure.find("steps_per_cycle") != std::string::npos);

  Trace thrown;
  CHECK_THROWS_WITH_AS(decay(
                           std::make_shared<FailingLaw>(150), [](auto&) {}, thrown),
                       "the law has had enough", std::domain_error);
}

void check_integrator(const Integrator& integrator, double order_within) {
  check_order(integrator, order_within);
  check_time(integrator);
  check_balance(integrator);
  check_held(integrator);
  check_drives(integrator);
  check_endings(integrator);
}

}  // namespace strandyn::test
