// Both integrators with the observers of a run: what goes on from a checkpoint equals what was never interrupted.
#include <doctest/doctest.h>

#include <map>
#include <random>
#include <set>
#include <vector>

#include "solver/vibration.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/observe/cycles.hpp"
#include "strandyn/solver/time/integrator.hpp"

using namespace strandyn;
using model::Freedom;
using observe::StepRecord;
using solver::IntegratorOptions;
using solver::IntegratorSummary;
using system::System;
using system::Vector;
using test::Vibration;

namespace {

using Integrator = std::function<IntegratorSummary(Vibration&, double amplitude, const IntegratorOptions&,
                                                   std::span<observe::Observer* const>)>;

const Integrator ida = [](Vibration& vibration, double amplitude, const IntegratorOptions& options, auto observers) {
  return solver::integrate(vibration.system, vibration.start(amplitude), options, solver::Ida{}, observers);
};
const Integrator generalized_alpha = [](Vibration& vibration, double amplitude, const IntegratorOptions& options,
                                        auto observers) {
  return solver::integrate(vibration.system, vibration.start(amplitude), options,
                           solver::GeneralizedAlpha{.rho_inf = 0.8}, observers);
};

struct Step {
  double time = 0, step = 0;
  int order = 0;
  Vector u, v, a;
  system::Accepted accepted;
};

/// Remembers the steps that it has seen itself.
class Steps final : public observe::Observer {
 public:
  void begin(const System&, const StepRecord&) override {}
  void step(const System&, const StepRecord& r) override {
    seen.push_back(
        {.time = r.time, .step = r.step, .order = r.order, .u = r.u, .v = r.v, .a = r.a, .accepted = r.accepted});
  }
  void archive(Archive&) override {}

  std::vector<Step> seen;
};

bool is_same(const Step& x, const Step& y) {
  return x.time == y.time && x.step == y.step && x.order == y.order && x.u == y.u && x.v == y.v && x.a == y.a &&
         x.accepted.elastic == y.accepted.elastic && x.accepted.friction == y.accepted.friction &&
         x.accepted.quadrature_error == y.accepted.quadrature_error;
}

template <class T>
std::string bytes_of(T& x) {
  Archive a;
  a(x);
  return a.bytes();
}

struct Scene {
  Freedom freedom = Freedom::planar;
  std::size_t elements = 20;
  double amplitude = 5e-3;  // [m]
  double steps = 100;       // per cycle
  int most_iterations = 12;
  double relative_error = 0;
  bool corners = false;
  bool losses = false;  // to air, by all parts of its force, and to the metal
};

/// What a run leaves behind.
struct Outcome {
  IntegratorSummary summary;
  std::vector<Step> steps;
  std::string system, cycles;
  double friction = 0;
  std::map<std::size_t, std::string> kept;  // by the number of steps taken
};

Outcome run(const Integrator& integrator, const Scene& scene, const std::set<std::size_t>& keep_at,
            const std::string& resume = "") {
  test::SpanOptions span{.length = 10, .elements = scene.elements, .drag = 0.5, .freedom = scene.freedom};
  if (scene.losses) span.material = section::branches_of(section::material_loss({1e7, 300, 2400, 2400}, 1e-3));
  Vibration vibration(test::return_map(scene.freedom), span, 4);
  if (scene.losses) {
    vibration.model.surroundings = {.air = {.drag_coefficient = 1, .drag_per_K = 0.2}, .diameter = 0.0317};
    vibration.system.set_swing(vibration.mode.frequency);
  }
  if (scene.corners) {
    vibration.model.loads = {
        {.node = 3,
         .force = {0, 200, 0},
         .history = model::Tabulated{.time = {0, 0.0131, 0.0402, 0.0602}, .value = {0, 1, -1, 0}}}};
  }
  IntegratorOptions options = vibration.options(scene.steps, 3);
  options.max_newton_iterations = scene.most_iterations;
  options.relative_error = scene.relative_error;
  Outcome outcome;
  std::size_t steps = 0;
  options.checkpoints.resume = resume;
  if (!keep_at.empty()) {
    options.checkpoints.due = [&] { return keep_at.contains(++steps); };
    options.checkpoints.keep = [&](const std::string& state) { outcome.kept[steps] = state; };
  }
  Steps watch;
  observe::CycleObserver cycles({.period = vibration.period(), .loop_length = 2.5, .kept = 2});
  observe::Observer* const observers[] = {&watch, &cycles};
  outcome.summary = integrator(vibration, scene.amplitude, options, observers);
  REQUIRE_MESSAGE(outcome.summary.ending == solver::Ending::finished, outcome.summary.failure);
  outcome.steps = watch.seen;
  outcome.system = bytes_of(vibration.system);
  outcome.cycles = bytes_of(cycles);
  outcome.friction = cycles.ledger().now().friction;
  return outcome;
}

std::vector<Integrator> kept_integrators() {
  if (solver::ida_has_checkpoints()) return {ida, generalized_alpha};
  return {generalized_alpha};
}

/// Ten random steps and the first.
std::set<std::size_t> some_of(std::size_t steps) {
  std::mt19937 random(11);
  std::uniform_int_distribution<std::size_t> any(1, steps);
  std::set<std::size_t> chosen = {1};
  while (chosen.size() < 11) chosen.insert(any(random));
  return chosen;
}

Outcome check_resume(const Integrator& integrator, const Scene& scene) {
  const std::size_t count = run(integrator, scene, {}).steps.size();
  const Outcome whole = run(integrator, scene, some_of(count));
  REQUIRE(whole.kept.size() == 11);
  CHECK(whole.friction > 0);
  for (const auto& [at, state] : whole.kept) {
    CAPTURE(at);
    const Outcome rest = run(integrator, scene, {}, state);
    REQUIRE(rest.steps.size() == count - at);
    std::size_t same = 0;
    for (std::size_t i = 0; i < rest.steps.size(); ++i) same += is_same(rest.steps[i], whole.steps[at + i]) ? 1 : 0;
    CHECK(same == rest.steps.size());
    CHECK(rest.system == whole.system);
    CHECK(rest.cycles == whole.cycles);
    CHECK(rest.summary.steps == whole.summary.steps);
    CHECK(rest.summary.rejected_steps == whole.summary.rejected_steps);
    CHECK(rest.summary.order_one_steps == whole.summary.order_one_steps);
    CHECK(rest.summary.newton_iterations == whole.summary.newton_iterations);
    CHECK(rest.summary.end_time == whole.summary.end_time);
  }
  return whole;
}

}  // namespace

TEST_CASE("checkpoint: ten random steps of a slipping span from which IDA goes on to the same bits" *
          doctest::skip(!solver::ida_has_checkpoints())) {
  check_resume(ida, {});
  CHECK(check_resume(ida, {.corners = true}).steps.size() > 330);  // each corner is a new start
  check_resume(ida, {.freedom = Freedom::transverse_planar});      // factors with an update of rank one
  check_resume(ida, {.freedom = Freedom::spatial, .elements = 8, .steps = 40});
  check_resume(ida, {.losses = true});
}

TEST_CASE("checkpoint: ten random steps of a slipping span from which generalized alpha goes on to the same bits") {
  check_resume(generalized_alpha, {});
  check_resume(generalized_alpha, {.corners = true});
  check_resume(generalized_alpha, {.freedom = Freedom::transverse_planar});
  check_resume(generalized_alpha, {.freedom = Freedom::spatial, .elements = 8, .steps = 40});
  check_resume(generalized_alpha, {.losses = true});
}

TEST_CASE("checkpoint: a step that was cut goes on within its parts") {
  Scene scene{.amplitude = 3e-2, .steps = 50, .most_iterations = 5};
  CHECK(check_resume(generalized_alpha, scene).summary.rejected_steps > 2);
  if (solver::ida_has_checkpoints()) CHECK(check_resume(ida, scene).summary.rejected_steps > 2);
}

TEST_CASE("checkpoint: IDA without checkpoints says so and names the way out" *
          doctest::skip(solver::ida_has_checkpoints())) {
  CHECK_THROWS_WITH_AS(run(ida, {}, {1}), doctest::Contains("method = \"generalized-alpha\""), InputError);
  CHECK_THROWS_WITH_AS(run(ida, {}, {}, "a state"), doctest::Contains("integrator.checkpoint_every_s"), InputError);
}

TEST_CASE("checkpoint: IDA with its own control of the error goes on to the same bits" *
          doctest::skip(!solver::ida_has_checkpoints())) {
  check_resume(ida, {.steps = 20, .relative_error = 1e-3});
}

TEST_CASE("checkpoint: to keep states changes nothing in the run") {
  const Scene scene;
  for (const Integrator& integrator : kept_integrators()) {
    const Outcome quiet = run(integrator, scene, {});
    const Outcome kept = run(integrator, scene, some_of(quiet.steps.size()));
    CHECK(kept.system == quiet.system);
    CHECK(kept.cycles == quiet.cycles);
  }
}

TEST_CASE("checkpoint: a state of another span or another integrator is refused") {
  const auto check = [](const Integrator& integrator, const Integrator& other) {
    const std::string state = run(integrator, {}, {5}).kept.at(5);
    CHECK_THROWS_AS(run(integrator, {.elements = 12}, {}, state), InputError);
    CHECK_THROWS_AS(run(integrator, {.freedom = Freedom::transverse_planar}, {}, state), InputError);
    CHECK_THROWS_AS(run(other, {}, {}, state), InputError);
    CHECK_THROWS_AS(run(integrator, {}, {}, state.substr(0, state.size() / 2)), FileError);
    CHECK_THROWS_AS(run(integrator, {}, {}, state + "x"), FileError);
  };
  if (solver::ida_has_checkpoints()) check(ida, generalized_alpha);
  check(generalized_alpha, ida);
}

TEST_CASE("checkpoint: an observer that cannot be kept is named and not forgotten") {
  class Forgetful final : public observe::Observer {
    void begin(const System&, const StepRecord&) override {}
    void step(const System&, const StepRecord&) override {}
  };
  Vibration vibration(test::stick_law(), {.length = 10, .elements = 4}, 1);
  IntegratorOptions options = vibration.options(20, 1);
  options.checkpoints = {.due = [] { return true; }, .keep = [](const std::string&) {}};
  Forgetful forgetful;
  observe::Observer* const observers[] = {&forgetful};
  CHECK_THROWS_AS(generalized_alpha(vibration, 1e-3, options, observers), ComputationError);
}
