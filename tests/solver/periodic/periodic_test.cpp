// The steady response solved directly, against dense solutions, transients and balances of power.
#include "strandyn/solver/periodic/periodic.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "solver/vibration.hpp"
#include "strandyn/analysis/methods.hpp"
#include "strandyn/solver/time/integrator.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using strandyn::model::Freedom;
using strandyn::model::MassMatrix;
using strandyn::model::Unknown;
using strandyn::solver::DriveKind;
using strandyn::solver::LoopPoint;
using strandyn::solver::PeriodicOptions;
using strandyn::solver::PeriodicSetup;
using strandyn::solver::PeriodicSolution;
using strandyn::solver::PeriodicSolver;
using strandyn::system::System;
using strandyn::system::Vector;
using strandyn::test::check_close;
using strandyn::test::SpanOptions;
using strandyn::test::Vibration;
using strandyn::test::zeros;

namespace {

constexpr double pi = std::numbers::pi;
using Complex = std::complex<double>;

/// A short span in its second mode, so stiff at its clamps that slip shows in the frequency. 16 elements.
SpanOptions short_span() {
  return {.length = 3, .elements = 16};
}

std::size_t antinode(const Vibration& v) {
  std::size_t best = 0;
  const auto size = [&](std::size_t n) { return std::abs(v.model.displacement(v.mode.shape.data(), n).y()); };
  for (std::size_t node = 0; node < v.model.nodes.size() / 2; ++node) {
    if (size(node) > size(best)) best = node;
  }
  return best;
}

/// Driven near its left clamp, as a shaker does.
PeriodicSetup shaker(const Vibration& v) {
  return {.drive = {.node = model::nearest_node(v.model, 0.1 * v.model.nodes.back().x())},
          .control = {.node = antinode(v)}};
}

/// A bar between two supports that moves along its axis only: linear to rounding, with drag and a dashpot.
struct DampedBar {
  explicit DampedBar(bool moved = false) {
    model::lay_out(model, {.positions = {0, 0.25, 0.5, 0.75, 1}, .strain = 0});
    model.supports = {{.node = 0, .fixed = {true, true, true, true, true, true}},
                      {.node = 4, .fixed = {!moved, true, true, true, true, true}}};
    if (moved) model.motions = {{.node = 4, .unknown = Unknown::x, .amplitude = 1}};
    model.law = test::linear_law(1e4, 1e2);
    model.inertia = {.mass = 1};
    model.drag = 3;
    model.bodies = {{.node = 3, .mass = 0.2, .stiffness = 500, .damping = 8, .direction = Eigen::Vector3d::UnitX()}};
  }
  static std::size_t place(std::size_t node) { return 3 * node; }

  /// By a dense solution: K from its five unknowns along x, worked out by hand.
  Eigen::VectorXcd response(double omega, double force_at_1, double motion_of_4) const {
    const double k = 1e4 / 0.25;
    const double m = 0.25;
    const double c = 3 * 0.25;
    Eigen::Matrix3cd D = Eigen::Matrix3cd::Zero();
    for (int i = 0; i < 3; ++i) {
      D(i, i) = Complex(2 * k - omega * omega * m, omega * c);
      if (i > 0) D(i, i - 1) = D(i - 1, i) = -k;
    }
    D(2, 2) += Complex(500 - omega * omega * 0.2, omega * 8);
    const Eigen::Vector3cd f(force_at_1, 0, k * motion_of_4);
    return D.partialPivLu().solve(f);
  }

  model::Model model;
};

struct Steady {
  double friction = 0;   // [J] of the last cycle
  double amplitude = 0;  // [m] of the control
  double evaluations_per_cycle = 0;
};

class LastCycle final : public observe::Observer {
 public:
  LastCycle(double start, std::size_t unknown) : start_(start), unknown_(unknown) {}
  void begin(const System&, const observe::StepRecord&) override {}
  void step(const System&, const observe::StepRecord& record) override {
    if (record.time <= start_ * (1 + 1e-12)) return;
    steady.friction += record.accepted.friction - record.accepted.quadrature_error;
    steady.amplitude = std::max(steady.amplitude, std::abs(record.u(static_cast<Eigen::Index>(unknown_))));
  }
  Steady steady;

 private:
  double start_;
  std::size_t unknown_;
};

/// The same drive in time, from the periodic state on; the drive of a transient is a sine.
Steady transient(Vibration& v, const PeriodicSetup& setup, const PeriodicSolution& solution, double cycles) {
  v.model.loads = {{.node = setup.drive.node,
                    .force = {0, solution.state.drive, 0},
                    .history = model::Harmonic{.frequency = solution.state.frequency}}};
  v.system.begin(v.rest);
  const Eigen::MatrixXd& x = solution.state.harmonics;
  solver::InitialMotion start{.u = x.col(0), .v = zeros(v.model)};
  for (Eigen::Index k = 1; 2 * k < x.cols(); ++k) {  // a quarter of a cycle before the crest of the force
    const double c = std::cos(static_cast<double>(k) * pi / 2);
    const double s = -std::sin(static_cast<double>(k) * pi / 2);
    const double rate = 2 * pi * solution.state.frequency * static_cast<double>(k);
    start.u += c * x.col(2 * k - 1) + s * x.col(2 * k);
    start.v += rate * (c * x.col(2 * k) - s * x.col(2 * k - 1));
  }
  for (std::size_t i = 0; i < v.system.unknowns(); ++i) {
    if (!v.system.has_mass(i)) start.v(static_cast<Eigen::Index>(i)) = 0;
  }
  const double period = 1 / solution.state.frequency;
  LastCycle last((cycles - 1) * period, *v.model.index(setup.control.node, Unknown::y));
  observe::Observer* const observers[] = {&last};
  const auto before = v.system.effort().evaluations;
  integrate(v.system, start, {.step = period / 200, .end_time = cycles * period, .stop = {}},
            solver::GeneralizedAlpha{.rho_inf = 0.9}, observers);
  last.steady.evaluations_per_cycle = static_cast<double>(v.system.effort().evaluations - before) / cycles;
  v.model.loads.clear();
  v.system.begin(v.rest);
  return last.steady;
}

}  // namespace

TEST_CASE("periodic: a linear bar with drag and a dashpot answers a force as the dense complex solution says") {
  const DampedBar bar;
  System system(bar.model);
  system.begin(zeros(bar.model));
  const PeriodicSolver solver(system, zeros(bar.model), {.drive = {1, Unknown::x}, .control = {2, Unknown::x}});
  for (const double omega : {30.0, 280.0, 310.0, 700.0}) {
    const PeriodicSolution s = solver.forced(omega / (2 * pi), 7);
    CHECK(s.converged);
    const Eigen::VectorXcd expected = bar.response(omega, 7, 0);
    for (std::size_t node : {1, 2, 3}) {
      const Complex off = s.state.phasor(DampedBar::place(node)) - expected(static_cast<Eigen::Index>(node) - 1);
      CHECK(std::abs(off) < 1e-8 * expected.norm());
    }
    const double power = 7 * omega / 2 * (-expected(0).imag());
    check_close(s.drive_power, power, {.relative = 1e-8});
    check_close(s.viscous.total() * omega / (2 * pi), power, {.relative = 1e-8});
  }
}

TEST_CASE("periodic: a moved support drives the bar as the dense solution says and its reaction brings the power") {
  const DampedBar bar(true);
  System system(bar.model);
  system.begin(zeros(bar.model));
  const PeriodicSolver solver(system, zeros(bar.model),
                              {.kind = DriveKind::motion, .drive = {4, Unknown::x}, .control = {2, Unknown::x}});
  const double omega = 290;
  const PeriodicSolution s = solver.forced(omega / (2 * pi), 1e-3);
  CHECK(s.converged);
  const Eigen::VectorXcd expected = bar.response(omega, 0, 1e-3);
  for (std::size_t node : {1, 2, 3}) {
    const Complex off = s.state.phasor(DampedBar::place(node)) - expected(static_cast<Eigen::Index>(node) - 1);
    CHECK(std::abs(off) < 1e-8 * expected.norm());
  }
  CHECK(std::abs(s.imbalance()) < 1e-8);

  const PeriodicSolution r = solver.resonance(0.02, s.state);
  CHECK(r.converged);
  CHECK(r.state.drive > 0);
  check_close(r.amplitude, 0.02, {.relative = 1e-9});
  CHECK(std::abs(r.state.phasor(DampedBar::place(2)).real()) < 1e-10);
  CHECK(std::abs(r.imbalance()) < 1e-8);
}

TEST_CASE("periodic: at phase resonance the bar's force is in quadrature and the amplitude as asked") {
  const DampedBar bar;
  System system(bar.model);
  system.begin(zeros(bar.model));
  const PeriodicSolver solver(system, zeros(bar.model), {.drive = {1, Unknown::x}, .control = {2, Unknown::x}});
  const PeriodicSolution s = solver.resonance(0.01, solver.forced(300 / (2 * pi), 7).state);
  CHECK(s.converged);
  const Eigen::VectorXcd expected = bar.response(2 * pi * s.state.frequency, s.state.drive, 0);
  CHECK(std::abs(expected(0).real()) < 1e-8 * std::abs(expected(0)));
  check_close(std::abs(expected(1)), 0.01, {.relative = 1e-8});
}

TEST_CASE("periodic: below first slip friction is exactly zero and drag or modal damping takes all of the power") {
  SpanOptions span = short_span();
  span.drag = 2;
  Vibration v(test::return_map(), span, 2);
  const PeriodicSolver solver(v.system, v.rest, shaker(v));
  const PeriodicSolution dragged = solver.resonance(5e-4, solver.from_mode(v.mode, 5e-4));
  CHECK(dragged.converged);
  CHECK(dragged.friction == 0.0);
  CHECK(std::abs(dragged.imbalance()) < 1e-6);

  v.model.drag = 0;
  Vibration w(test::return_map(), short_span(), 2);
  Vector momentum(w.rest.size());
  system::Matrix M = w.system.make_matrix();
  w.system.mass_matrix(w.rest.data(), M);
  M.multiply(w.mode.shape.data(), momentum.data());
  w.system.set_damping(
      {.rayleigh = {}, .modes = {{.momentum = momentum, .factor = 2 * 1e-3 * w.omega() / w.mode.modal_mass}}});
  const PeriodicSetup setup = shaker(w);
  const PeriodicSolver modal(w.system, w.rest, setup);
  const double Y = 5e-4;
  const PeriodicSolution s = modal.resonance(Y, modal.from_mode(w.mode, Y));
  CHECK(s.converged);
  CHECK(s.friction == 0.0);
  CHECK(std::abs(s.imbalance()) < 1e-6);
  // P = 2 zeta omega (kinetic energy): the shape is the mode's to the order of (Y k)^2 and zeta.
  const double share = w.mode.shape(static_cast<Eigen::Index>(*w.model.index(setup.control.node, Unknown::y)));
  const double velocity = s.state.frequency * 2 * pi * Y / share;
  check_close(s.drive_power, 1e-3 * w.omega() * w.mode.modal_mass * velocity * velocity, {.relative = 1e-3});
  // And the given drive at that frequency leads back to it.
  const PeriodicSolution forced = modal.forced(s.state.frequency, s.state.drive, s.state);
  check_close(forced.amplitude, Y, {.relative = 1e-7});
}

TEST_CASE("periodic: slip makes the span softer and the drive brings what the loops of the sections take") {
  Vibration v(test::return_map(), short_span(), 2);
  const PeriodicSolver solver(v.system, v.rest, shaker(v));
  const auto backbone = solver.backbone({9e-4, 1.2e-3, 2.4e-3, 4.8e-3, 7.2e-3}, v.mode);
  REQUIRE(backbone.size() == 5);
  double before = 0;
  for (const PeriodicSolution& s : backbone) {
    CAPTURE(s.failure);
    CHECK(s.converged);
    CHECK(std::abs(s.imbalance()) < 1e-6);
    CHECK(s.friction > 0);
    // Two ways: area of the loops and the law's own booking, which differ by O(1/N^2). Measured: below 0.3 %.
    check_close(s.loop_work, s.friction, {.relative = 5e-3});
    if (before > 0) CHECK(s.state.frequency < before);
    before = s.state.frequency;
    for (const double d : s.sections.friction) CHECK(d >= 0.0);
  }
  // Partial slip begins at the clamps.
  CHECK(backbone.front().sections.friction.front() > 0);
  CHECK(backbone.front().sections.friction[10] == 0.0);
}

TEST_CASE("periodic: a neighbour begun with what the sections of a solution answered is the same at less cost") {
  Vibration v(test::return_map(), short_span(), 2);
  const PeriodicSolver solver(v.system, v.rest, shaker(v)), other(v.system, v.rest, shaker(v), {.harmonics = 2});
  const PeriodicSolution from = solver.backbone({1.2e-3, 2.4e-3, 4.8e-3}, v.mode).back();
  REQUIRE(from.converged);
  REQUIRE(from.state.sections);
  solver::PeriodicState alone = from.state;
  alone.sections.reset();
  for (const PeriodicSolver* to : {&solver, &other}) {
    solver::PeriodicState begin = from.state, bare = alone;
    const Eigen::Index columns = to == &solver ? 7 : 5;
    begin.harmonics = bare.harmonics = from.state.harmonics.leftCols(columns).eval();
    const PeriodicSolution known = to->resonance(4.9e-3, begin), unknown = to->resonance(4.9e-3, bare);
    REQUIRE(known.converged);
    REQUIRE(unknown.converged);
    check_close(known.loop_work, unknown.loop_work, {.relative = 1e-6});
    check_close(known.state.frequency, unknown.state.frequency, {.relative = 1e-8});
    CHECK(known.effort.evaluations < unknown.effort.evaluations);
  }
}

TEST_CASE("periodic: a transient driven alike stays in the periodic state in partial and in gross slip") {
  Vibration v(test::return_map(), short_span(), 2);
  const PeriodicSetup setup = shaker(v);
  const PeriodicSolver solver(v.system, v.rest, setup);
  const std::size_t control = *v.model.index(setup.control.node, Unknown::y);
  for (const double Y : {1.2e-3, 4.8e-3}) {
    const PeriodicSolution s = solver.backbone({0.6 * Y, Y}, v.mode).back();
    REQUIRE(s.converged);
    // zeta is 1.3 % and 7 %: what the start, near the end already, was off by has fallen by exp(-3) and more.
    const Steady steady = transient(v, setup, s, 40);
    // The transient's frequency is off by (omega h)^2/12 = 8e-5, its loops by their chords: (omega h)^2/6.
    // Measured: the loss 0.06 % and 0.4 % off.
    check_close(steady.friction, s.loop_work, {.relative = 0.01});
    check_close(steady.amplitude, std::abs(s.state.phasor(control)), {.relative = 0.01});
  }
}

TEST_CASE("periodic: at the smallest dissipating amplitude it asks the sections a hundredth of what a transient does") {
  Vibration v(test::return_map(), short_span(), 2);
  const PeriodicSetup setup = shaker(v);
  const PeriodicSolver solver(v.system, v.rest, setup);
  const PeriodicSolution s = solver.resonance(7.5e-4, solver.from_mode(v.mode, 7.5e-4));
  REQUIRE(s.converged);
  REQUIRE(s.friction > 0);
  const Steady steady = transient(v, setup, s, 2);
  // From rest the amplitude arrives with exp(-zeta omega t): within 1 % in the dissipation, 0.5 % in the amplitude.
  const double velocity = 2 * pi * s.state.frequency * s.amplitude;
  const double energy = v.mode.modal_mass * velocity * velocity / 2;
  const double zeta = s.loop_work / (4 * pi * energy);
  const double cycles = std::log(200) / (2 * pi * zeta);
  const double ratio = cycles * steady.evaluations_per_cycle / static_cast<double>(s.effort.evaluations);
  MESSAGE("zeta " << zeta << ", " << cycles
                  << " cycles, section evaluations of the transient over periodic: " << ratio);
  CHECK(ratio > 100);
}

TEST_CASE("periodic: more samples and more harmonics change the result by less than they promise") {
  Vibration v(test::return_map(), short_span(), 2);
  const auto solve = [&](int harmonics, int samples) {
    const PeriodicSolver solver(v.system, v.rest, shaker(v), {.harmonics = harmonics, .samples = samples});
    return solver.backbone({1.2e-3, 2.4e-3}, v.mode).back();
  };
  const PeriodicSolution standard = solve(3, 64);
  const PeriodicSolution finer = solve(3, 128);
  const PeriodicSolution richer = solve(7, 64);
  REQUIRE(finer.converged);
  REQUIRE(richer.converged);
  // zeta is 4 % here. Measured: N 64 to 128 less than 0.1 %, H 3 to 7 0.6 % of the loss and 4e-4 of the frequency.
  check_close(standard.loop_work, finer.loop_work, {.relative = 3e-3});
  check_close(standard.state.frequency, finer.state.frequency, {.relative = 1e-4});
  check_close(standard.loop_work, richer.loop_work, {.relative = 1e-2});
  check_close(standard.state.frequency, richer.state.frequency, {.relative = 6e-4});
  // The law's friction and the area of the loops meet as the samples grow.
  CHECK(std::abs(finer.friction - finer.loop_work) < 0.5 * std::abs(standard.friction - standard.loop_work));
}

TEST_CASE("periodic: chains of every freedom find the same resonance of a slipping span") {
  const auto solve = [](Freedom freedom) {
    SpanOptions span = short_span();
    span.freedom = freedom;
    Vibration v(test::return_map(freedom), span, 2);
    const PeriodicSolver solver(v.system, v.rest, shaker(v));
    return solver.resonance(1.2e-3, solver.from_mode(v.mode, 1.2e-3));
  };
  const PeriodicSolution planar = solve(Freedom::planar);
  for (const auto freedom : {Freedom::spatial, Freedom::spatial_untwisted, Freedom::transverse_planar}) {
    CAPTURE(static_cast<int>(freedom));
    const PeriodicSolution s = solve(freedom);
    CAPTURE(s.failure);
    CHECK(s.converged);
    CHECK(std::abs(s.imbalance()) < 1e-6);
    // The transverse chain leaves axial inertia out: terms of (Y k)^2.
    check_close(s.loop_work, planar.loop_work, {.relative = 2e-3});
    check_close(s.state.frequency, planar.state.frequency, {.relative = 1e-4});
  }
}

TEST_CASE("periodic: a sweep passes the peak where the resonance was found") {
  Vibration v(test::return_map(), short_span(), 2);
  const PeriodicSolver solver(v.system, v.rest, shaker(v));
  const PeriodicSolution peak = solver.resonance(1.2e-3, solver.from_mode(v.mode, 1.2e-3));
  REQUIRE(peak.converged);
  const auto points = solver.sweep({.from = 50, .to = 58, .drive = peak.state.drive, .frequency_step = 2});
  CAPTURE(points.back().failure);
  REQUIRE(points.back().converged);
  check_close(points.back().state.frequency, 58, {.relative = 1e-9});
  double largest = 0;
  for (const PeriodicSolution& p : points) {
    largest = std::max(largest, p.amplitude);
    if (p.friction > 1e-6) CHECK(std::abs(p.imbalance()) < 1e-6);  // off resonance nothing slips
  }
  // The peak of amplitude lies beside that of phase by terms of zeta, and points miss it by the step.
  check_close(largest, 1.2e-3, {.relative = 0.03});
}

TEST_CASE("periodic: the tension of a large swing bends the resonance over and the sweep goes around both folds") {
  SpanOptions span{.length = 10, .elements = 12, .graded = false, .drag = 0.3};
  Vibration v(test::stick_law(), span, 1);
  const PeriodicSolver solver(v.system, v.rest, shaker(v));
  const PeriodicSolution peak = solver.resonance(0.03, solver.from_mode(v.mode, 0.03));
  REQUIRE(peak.converged);
  CHECK(peak.state.frequency > 1.01 * v.mode.frequency);
  const double from = 0.95 * v.mode.frequency;
  const double to = 1.1 * v.mode.frequency;
  const auto points = solver.sweep({.from = from, .to = to, .drive = peak.state.drive, .frequency_step = 0.1});
  CAPTURE(points.back().failure);
  REQUIRE(points.back().converged);
  int folds = 0;
  double largest = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double before = points[i].state.frequency - points[i - 1].state.frequency;
    const double after = points[i + 1].state.frequency - points[i].state.frequency;
    folds += before * after < 0;
    largest = std::max(largest, points[i].amplitude);
  }
  CHECK(folds == 2);
  check_close(largest, 0.03, {.relative = 0.02});
}

TEST_CASE("periodic: nodes and antinodes tell the power that runs through a node") {
  // A taut span whose second loop is fed through the node in the middle: half of all drag is beyond it.
  SpanOptions span{.length = 30, .elements = 40, .clamped = false, .graded = false, .drag = 0.05};
  span.mass = MassMatrix::consistent;
  Vibration v(test::slip_law(), span, 2);
  const PeriodicSolver solver(v.system, v.rest, shaker(v));
  const PeriodicSolution s = solver.resonance(1e-3, solver.from_mode(v.mode, 1e-3));
  REQUIRE(s.converged);
  const std::vector<LoopPoint> points = solver.loop_points(s.state);
  REQUIRE(points.size() == 3);
  CHECK(points[0].antinode);
  CHECK(!points[1].antinode);
  check_close(points[1].position, 15, {.relative = 1e-2});
  check_close(points[0].amplitude, 1e-3, {.relative = 1e-3});
  const double power =
      analysis::power_at_node({.node_amplitude = points[1].amplitude, .antinode_amplitude = points[2].amplitude},
                              {.tension = test::curlew_tension,
                               .mass_per_length = test::curlew_mass,
                               .EI = conductor::section_constants(test::curlew()).EI_min},
                              s.state.frequency);
  check_close(power, s.drive_power / 2, {.relative = 0.01});
}

TEST_CASE("periodic: what cannot be is refused and what does not converge says where") {
  Vibration v(test::return_map(), short_span(), 2);
  PeriodicSetup setup = shaker(v);
  CHECK_THROWS_WITH_AS(PeriodicSolver(v.system, v.rest, setup, {.samples = 15}),
                       "PeriodicOptions: samples must be 4 harmonics + 4 or more", std::invalid_argument);
  setup.control.node = 0;
  CHECK_THROWS_WITH_AS(PeriodicSolver(v.system, v.rest, setup),
                       "periodic response: the control, node 0 displacement y, is held by a support",
                       std::invalid_argument);
  const PeriodicSolver solver(v.system, v.rest, shaker(v), {.max_iterations = 1});
  const PeriodicSolution s = solver.resonance(2e-3, solver.from_mode(v.mode, 2e-3));
  CHECK(!s.converged);
  CHECK(s.failure.find("no convergence in 1 iterations") != std::string::npos);
  CAPTURE(s.failure);
  CHECK(s.failure.find("of node ") != std::string::npos);
  const PeriodicSolver impatient(v.system, v.rest, shaker(v), {.max_cycles = 2, .closure = 1e-30});
  CHECK(impatient.resonance(2e-3, impatient.from_mode(v.mode, 2e-3)).failure.find("is open by") != std::string::npos);
}
