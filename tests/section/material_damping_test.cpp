// The branches of the metal: their loss factor, their steps, their account.
#include "strandyn/section/material_damping.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "conductor/strands.hpp"
#include "strandyn/conductor/constants.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using namespace strandyn::section;
using test::check_close;

namespace {

constexpr double pi = std::numbers::pi;

double loss_factor(const MaterialBranches& branches, double stiffness, double frequency) {
  return stiffness_at(branches, Component::bending2, 2 * pi * frequency).loss / stiffness;
}

/// A point on a path of curvature and axial strain.
class Point {
 public:
  explicit Point(const MaterialBranches& branches)
      : memory_(branches, Dimension::planar, 1), before_(Dimension::planar, 1), stresses_(before_) {}

  /// The trapezoidal work of the step. [J/m]
  double step(double curvature, double axial, double seconds) {
    Field strains = before_;
    strains[Component::bending2][0] = curvature;
    strains[Component::axial][0] = axial;
    const Field from = stresses_at(before_, 0);
    const Field to = stresses_at(strains, seconds);
    double work = 0;
    for (Component c : {Component::axial, Component::bending2}) {
      work += (from[c][0] + to[c][0]) / 2 * (strains[c][0] - before_[c][0]);
    }
    memory_.commit(before_, strains, seconds);
    before_ = strains;
    return work;
  }
  double moment() const { return stresses_at(before_, 0)[Component::bending2][0]; }
  const MaterialMemory& memory() const { return memory_; }

 private:
  Field stresses_at(const Field& strains, double seconds) const {
    Field stresses(Dimension::planar, 1);
    memory_.respond(before_, strains, seconds, stresses, nullptr);
    return stresses;
  }

  MaterialMemory memory_;
  Field before_, stresses_;
};

MaterialBranches curlew_branches() {
  const conductor::Strand strand = test::curlew();
  std::vector<Metal> metals(strand.layers.size(), {.loss_factor = 3e-4});
  metals.front().loss_factor = 1e-4;
  metals.back() = {.loss_factor = 3e-4, .thermal_strain = 23e-6, .heat_capacity = 2.43e6, .diffusivity = 9.6e-5};
  return branches_of(material_loss(strand, metals, 293, Wires::sticking));
}

}  // namespace

TEST_CASE("material: the loss factor is flat within one per cent from 1 to 200 Hz, and small beyond") {
  const MaterialBranches branches = branches_of(material_loss({1, 1, 2400, 2400}, 2e-4));
  CHECK(branches.size() == 6);
  for (int i = 0; i <= 400; ++i) {
    check_close(loss_factor(branches, 2400, std::pow(200.0, i / 400.0)), 2e-4, {.relative = 1e-2});
  }
  CHECK(loss_factor(branches, 2400, 1e-3) < 1e-5);
}

TEST_CASE("material: layers lose by their own loss factors, over all of their stiffness while they stick") {
  const conductor::Strand strand = test::curlew();
  double sticking = 0, slipping = 0;
  std::vector<Metal> metals;
  for (std::size_t j = 0; j < strand.layers.size(); ++j) {
    metals.push_back({.loss_factor = 1e-4 * static_cast<double>(j + 1)});
    const auto own = conductor::section_constants({.name = {}, .layers = {strand.layers[j]}});
    sticking += metals.back().loss_factor * own.EI_max;
    slipping += metals.back().loss_factor * own.EI_min;
  }
  const double omega = 2 * pi * 14;
  const auto loss = [&](Wires wires) {
    return stiffness_at(branches_of(material_loss(strand, metals, 293, wires)), Component::bending2, omega).loss;
  };
  const double flat = loss_factor(branches_of(material_loss({0, 0, 1, 1}, 1)), 1, 14);
  check_close(loss(Wires::sticking), flat * sticking, {.relative = 1e-12});
  check_close(loss(Wires::slipping), flat * slipping, {.relative = 1e-12});
}

TEST_CASE("material: heat flow across a wire peaks at its relaxation time with half its strength") {
  conductor::Strand wire = test::curlew();
  wire.layers.resize(1);
  const conductor::Layer& w = wire.layers.front();
  const Metal metal{.thermal_strain = 23e-6, .heat_capacity = 2.43e6, .diffusivity = 9.6e-5};
  const MaterialBranches branches = branches_of(material_loss(wire, {metal}, 293, Wires::sticking));
  REQUIRE(branches.size() == 1);
  const double tau = w.diameter * w.diameter / (13.55 * 9.6e-5);
  const double strength = w.young * 23e-6 * 23e-6 * 293 / 2.43e6;
  const auto eta = [&](double omega) { return stiffness_at(branches, Component::bending2, omega).loss / w.EI_wire(); };
  check_close(eta(1 / tau), strength / 2, {.relative = 1e-12});
  check_close(eta(0.1 / tau), strength * 0.1 / 1.01, {.relative = 1e-12});
  CHECK(stiffness_at(branches, Component::axial, 1 / tau).loss == 0);  // pulled, it is warm all over
}

TEST_CASE("material: a sine loses pi E'' chi^2 a cycle, to the square of the step") {
  const MaterialBranches branches = curlew_branches();
  const double frequency = 20, amplitude = 3e-3;
  const double expected =
      pi * stiffness_at(branches, Component::bending2, 2 * pi * frequency).loss * amplitude * amplitude;
  const auto error = [&](int steps) {
    Point point(branches);
    double lost = 0;
    constexpr int cycles = 60;  // the slowest branch has forgotten the start
    for (int i = 1; i <= cycles * steps; ++i) {
      point.step(amplitude * std::sin(2 * pi * i / steps), 0, 1 / (frequency * steps));
      if (i > (cycles - 1) * steps) lost += point.memory().dissipated()[0];
    }
    return std::abs(lost / expected - 1);
  };
  CHECK(error(200) < 1e-3);
  check_close(error(50) / error(100), 4, {.relative = 0.05});
  check_close(error(100) / error(200), 4, {.relative = 0.05});
}

TEST_CASE("material: in any step stored, lost and trapezoidal work balance, and nothing is won") {
  const MaterialBranches branches = curlew_branches();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> between(-1, 1);
  Point point(branches);
  double stored = 0, worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const double seconds = std::pow(10, 3 * between(random) - 4);  // far shorter and longer than the branches
    const double work = point.step(1e-2 * between(random), 1e-4 * between(random), seconds);
    const MaterialMemory& m = point.memory();
    CHECK(m.dissipated()[0] >= 0);
    const double sum = m.stored()[0] - stored + m.dissipated()[0] - m.quadrature_error()[0];
    const double size = m.stored()[0] + stored + m.dissipated()[0] + std::abs(work);
    worst = std::max(worst, std::abs(sum - work) / size);
    stored = m.stored()[0];
  }
  CHECK(worst < 1e-12);
}

TEST_CASE("material: a step in one piece or in ten of one slope ends in the same forces with the same loss") {
  const MaterialBranches branches = curlew_branches();
  Point whole(branches), parts(branches);
  whole.step(2e-3, 1e-5, 0.01);
  parts.step(2e-3, 1e-5, 0.01);
  whole.step(-1e-3, 3e-5, 0.02);
  double lost = 0;
  for (int i = 1; i <= 10; ++i) {
    parts.step(2e-3 - 3e-3 * i / 10, 1e-5 + 2e-5 * i / 10, 0.002);
    lost += parts.memory().dissipated()[0];
  }
  check_close(parts.moment(), whole.moment(), {.relative = 1e-12});
  check_close(lost, whole.memory().dissipated()[0], {.relative = 1e-11});
}

TEST_CASE("material: the tangent is the derivative of the response") {
  const MaterialBranches branches = curlew_branches();
  MaterialMemory memory(branches, Dimension::planar, 3);
  const Field before(Dimension::planar, 3);
  Field strains = before;
  const double step = 2e-3;
  const auto moment = [&](double curvature) {
    strains[Component::bending2][1] = curvature;
    Field stresses(Dimension::planar, 3);
    TangentField tangents(Dimension::planar, 3);
    memory.respond(before, strains, step, stresses, &tangents);
    return std::pair{stresses[Component::bending2][1], tangents(Component::bending2, Component::bending2)[1]};
  };
  const auto [at, slope] = moment(1e-3);
  check_close((moment(1.001e-3).first - moment(0.999e-3).first) / 2e-6, slope, {.relative = 1e-9});
  CHECK(at > 0);
}
