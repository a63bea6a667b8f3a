// Still air and the metal of the wires in the harmonic balance.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "solver/vibration.hpp"
#include "strandyn/solver/periodic/periodic.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using solver::PeriodicSolution;
using solver::PeriodicSolver;
using test::check_close;
using test::SpanOptions;
using test::Vibration;

namespace {

constexpr double pi = std::numbers::pi;

SpanOptions uniform_span(section::MaterialBranches material = {}) {
  return {.length = 3,
          .elements = 24,
          .clamped = false,
          .graded = false,
          .mass = model::MassMatrix::consistent,
          .material = std::move(material)};
}

PeriodicSolution resonance(const Vibration& v, double amplitude) {
  const solver::Place middle{.node = v.model.nodes.size() / 2};
  const solver::PeriodicSetup setup{.drive = {.node = 4}, .control = middle};
  const PeriodicSolver solver(v.system, v.rest, setup, {.harmonics = 3});
  PeriodicSolution s = solver.resonance(amplitude, solver.from_mode(v.mode, amplitude));
  REQUIRE_MESSAGE(s.converged, s.failure);
  return s;
}

}  // namespace

TEST_CASE("periodic: still air takes c V^2/4 per length of a string's loop, and the drive feeds it") {
  Vibration v(test::stick_law(), uniform_span(), 1);
  v.model.surroundings = {.air = {}, .diameter = 0.0317};
  const double amplitude = 1e-4;
  const PeriodicSolution s = resonance(v, amplitude);
  const air::AirForce force = air::force_at({}, 0.0317, s.state.frequency);
  const double power = force.power_of_loop(2 * pi * s.state.frequency * amplitude) * v.model.unstressed_length();
  check_close(s.air * s.state.frequency, power, {.relative = 2e-3});  // the shape is a beam's between pins: a sine
  double by_nodes = 0;
  for (double energy : s.air_by_node) by_nodes += energy;
  check_close(by_nodes, s.air, {.relative = 1e-12});
  check_close(s.imbalance(), 0, {.absolute = 1e-5});  // the drive is a thousandth of what it is known against
  CHECK(s.viscous.total() == 0);
}

TEST_CASE("periodic: what is not linear in the air's force is balanced as well") {
  Vibration v(test::stick_law(), uniform_span(), 1);
  v.model.surroundings = {.air = {.drag_coefficient = 1.2, .drag_per_K = 0.2}, .diameter = 0.0317};
  const double amplitude = 3e-3;
  const PeriodicSolution s = resonance(v, amplitude);
  const air::AirForce force = air::force_at(v.model.surroundings->air, 0.0317, s.state.frequency);
  const double power = force.power_of_loop(2 * pi * s.state.frequency * amplitude) * v.model.unstressed_length();
  CHECK(force.power_of_loop(1) > 1.5 * air::AirForce{.linear = force.linear}.power_of_loop(1));
  check_close(s.air * s.state.frequency, power, {.relative = 5e-3});
  check_close(s.imbalance(), 0, {.absolute = 1e-6});
}

TEST_CASE("periodic: the metal loses what its branches' own sum says") {
  const auto c = conductor::section_constants(test::curlew());
  const section::MaterialBranches branches =
      section::branches_of(section::material_loss({c.EA, c.GJ, c.EI_max, c.EI_max}, 3e-4));
  const Vibration v(test::stick_law(), uniform_span(branches), 1);
  const double amplitude = 1e-3;
  const PeriodicSolution s = resonance(v, amplitude);
  // Each harmonic of the curvature and of the axial strain by itself, from the solved state at 64 samples.
  double expected = 0;
  section::Field strains = v.system.committed_strains();
  const std::size_t points = strains.points();
  constexpr int samples = 64;
  for (const section::Component component : {section::Component::axial, section::Component::bending2}) {
    Eigen::MatrixXd at(static_cast<Eigen::Index>(points), samples);
    for (int j = 0; j < samples; ++j) {
      system::Vector u = v.rest + s.state.harmonics.col(0);
      for (Eigen::Index a = 1; a < s.state.harmonics.cols(); ++a) {
        const double angle = 2 * pi * j / samples * static_cast<double>((a + 1) / 2);
        u += (a % 2 == 1 ? std::cos(angle) : std::sin(angle)) * s.state.harmonics.col(a);
      }
      v.system.strains(u.data(), strains);
      for (std::size_t p = 0; p < points; ++p) at(static_cast<Eigen::Index>(p), j) = strains[component][p];
    }
    for (std::size_t p = 0; p < points; ++p) {
      for (int k = 1; k < samples / 2; ++k) {
        std::complex<double> sum = 0;
        for (int j = 0; j < samples; ++j) {
          sum += at(static_cast<Eigen::Index>(p), j) * std::polar(2.0 / samples, -2 * pi * j * k / samples);
        }
        const double loss = section::stiffness_at(branches, component, 2 * pi * s.state.frequency * k).loss;
        expected += v.system.point_length(p) * pi * k * loss * std::norm(sum);
      }
    }
  }
  check_close(s.material, expected, {.relative = 1e-8});
  check_close(s.imbalance(), 0, {.absolute = 1e-6});
  // And that is eta of the energy of bending, where the span is a string with a sine.
  const double k = pi / v.model.unstressed_length();
  const double of_sine = pi * 3e-4 * c.EI_max * std::pow(k * k * amplitude, 2) / 2 * v.model.unstressed_length();
  check_close(s.material, of_sine, {.relative = 3e-2});
}

TEST_CASE("periodic: no air and no loss factor is to the bit as if nobody had asked") {
  const Vibration bare(test::return_map(), {.length = 3, .elements = 16}, 1);
  SpanOptions options{.length = 3, .elements = 16};
  options.material = section::branches_of(section::material_loss({1, 1, 1, 1}, 0));
  CHECK(options.material.empty());
  const Vibration asked(test::return_map(), options, 1);
  const PeriodicSolution a = resonance(bare, 5e-3), b = resonance(asked, 5e-3);
  CHECK(a.friction > 0);
  CHECK(a.state.harmonics == b.state.harmonics);
  CHECK(b.material == 0);
  CHECK(b.air == 0);
}
