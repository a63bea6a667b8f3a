#include "strandyn/solver/static/equilibrium.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "strandyn/core/error.hpp"
#include "strandyn/exact/elastica.hpp"
#include "support/check_close.hpp"
#include "system/spans.hpp"

using namespace strandyn;
using strandyn::solver::find_equilibrium;
using strandyn::system::System;
using strandyn::system::Vector;
using strandyn::test::cantilever;
using strandyn::test::check_close;
using strandyn::test::curlew_span;
using strandyn::test::linear_law;
using strandyn::test::zeros;

namespace {

constexpr double pi = std::numbers::pi;

/// Displacement of the last node.
Eigen::Vector3d tip(const Vector& u) {
  return u.tail<3>();
}

Vector loaded_cantilever(model::Load load, std::size_t elements, int steps) {
  model::Model model = cantilever(linear_law(1e8, 1), 1, elements);
  load.node = elements;
  model.loads = {load};
  System system(model);
  Vector u = zeros(model);
  system.begin(u);
  find_equilibrium(system, u, {.steps = steps});
  return u;
}

}  // namespace

TEST_CASE("equilibrium: a cantilever rolls up into a closed circle under M = 2 pi EI/L") {
  for (const std::size_t elements : {10, 20}) {
    // Equal elements under equal moments: the polygon closes whatever their size. Measured 3e-14.
    const Vector u = loaded_cantilever({.moment = {0, 0, 2 * pi}}, elements, 20);
    check_close(tip(u)(2), 2 * pi, {.relative = 1e-10});
    check_close(tip(u)(0), -1, {.relative = 1e-10}, "the tip comes back to the clamp, x");
    check_close(tip(u)(1), 0, {.absolute = 1e-10}, "y");
    // Half way round it is a diameter away; measured 8e-5 and 5e-6.
    const Eigen::Vector3d middle = u.segment<3>(static_cast<Eigen::Index>(3 * elements / 2));
    check_close(middle(1), 1 / pi, {.relative = elements == 10 ? 1e-4 : 1e-5});
  }
}

TEST_CASE("equilibrium: twice the moment rolls the cantilever up twice") {
  const Vector u = loaded_cantilever({.moment = {0, 0, 4 * pi}}, 20, 40);
  check_close(tip(u)(2), 4 * pi, {.relative = 1e-10});
  check_close(tip(u)(0), -1, {.relative = 1e-10});
}

TEST_CASE("equilibrium: the tip of a cantilever under a dead load follows the elastica") {
  for (const double load : {0.1, 1.0, 10.0}) {
    const Vector u = loaded_cantilever({.force = {0, load, 0}}, 20, 10);
    const exact::CantileverTip expected = exact::cantilever_elastica({.force = load, .EI = 1, .length = 1});
    // Measured 9e-7 at the most.
    check_close(tip(u)(1), expected.deflection, {.relative = 2e-6}, "w");
    check_close(tip(u)(0), expected.shortening, {.relative = 2e-6}, "u");
    check_close(tip(u)(2), expected.slope, {.relative = 2e-6}, "slope");
  }
}

TEST_CASE("equilibrium: the elastica's tip converges with the fourth power of the element size") {
  const auto error = [](std::size_t elements) {
    const double expected = exact::cantilever_elastica({.force = 10, .EI = 1, .length = 1}).deflection;
    return std::abs(tip(loaded_cantilever({.force = {0, 10, 0}}, elements, 10))(1) - expected);
  };
  CHECK(std::log2(error(10) / error(20)) > 3.8);  // measured 4.1
}

TEST_CASE("equilibrium: without tension it is found although the axial stiffness rounds to more than the tolerance") {
  // EA = 1e8: the last digit of a strain is 2e-8 N, the tolerance of a load of 1e-3 N is 1e-13 N.
  const Vector u = loaded_cantilever({.force = {0, 1e-3, 0}}, 20, 1);
  check_close(tip(u)(1), 1e-3 / 3, {.relative = 1e-6});
}

TEST_CASE("equilibrium: a stretched bar carries its end load") {
  const double force = 3e4;
  model::Model model = cantilever(linear_law(47e6, 2000), 10, 5);
  model.loads = {{.node = 5, .force = {force, 0, 0}}};
  System system(model);
  Vector u = zeros(model);
  system.begin(u);
  std::vector<double> stretches;
  const auto keep = [&](const solver::EquilibriumStep&, const Vector& at, double) { stretches.push_back(tip(at)(0)); };
  const auto summary = find_equilibrium(system, u, {.steps = 4, .watch = keep});
  // u = (l^2 - l0^2)/(l + l0) = l - l0: linear in the strain.
  check_close(tip(u)(0), 10 * force / 47e6, {.relative = 1e-9});
  REQUIRE(summary.steps.size() == 4);
  check_close(summary.steps[1].load_factor, 0.5, {.relative = 1e-15});
  check_close(stretches.at(1), 5 * force / 47e6, {.relative = 1e-9});
}

TEST_CASE("equilibrium: a taut span bends under a force across it as a tensioned beam") {
  // Midspan deflection of a tensioned beam, clamped: P L/(4 T) [1 - 2 tanh(xi/4)/(xi/2)], xi = L sqrt(T/EI).
  model::Model model = curlew_span(test::stick_law(), {.elements = 80});
  model.loads = {{.node = 40, .force = {0, 10, 0}}};
  System system(model);
  Vector u = zeros(model);
  system.begin(u);
  find_equilibrium(system, u, {});
  const double EI = conductor::section_constants(test::curlew()).EI_max;
  const double xi = 30 * std::sqrt(test::curlew_tension / EI);
  const double expected = 10 * 30 / (4 * test::curlew_tension) * (1 - 4 * std::tanh(xi / 4) / xi);
  // The load of 10 N raises the tension by 4 N.
  check_close(u(3 * 40 + 1), expected, {.relative = 1e-3});
}

TEST_CASE("equilibrium: each load step is committed and tells how many sections slip") {
  model::Model model = curlew_span(test::return_map(), {.length = 6, .elements = 20});
  model.loads = {{.node = 10, .force = {0, 2000, 0}}};
  System system(model);
  Vector u = zeros(model);
  system.begin(u);
  const auto loaded = find_equilibrium(system, u, {.steps = 10});
  CHECK(loaded.steps.front().sections_slipping <= loaded.steps.back().sections_slipping);
  CHECK(loaded.steps.back().sections_slipping > 0);
  const double deflected = u(31);
  // Without the load, friction keeps part of the deflection.
  model.loads.clear();
  find_equilibrium(system, u, {});
  CHECK(u(31) > 0.01 * deflected);
  CHECK(u(31) < 0.5 * deflected);
}

TEST_CASE("equilibrium: a load that is too much for one step is cut into smaller ones") {
  model::Model model = cantilever(linear_law(1e8, 1), 1, 20);
  model.loads = {{.node = 20, .moment = {0, 0, 2 * pi}}};
  System system(model);
  Vector u = zeros(model);
  system.begin(u);
  const auto summary = find_equilibrium(system, u, {.steps = 1});
  CHECK(summary.steps.size() > 1);
  check_close(summary.steps.back().load_factor, 1, {.relative = 1e-12});
  check_close(tip(u)(2), 2 * pi, {.relative = 1e-10});
}

TEST_CASE("equilibrium: where there is none the message names step and load and node") {
  // Nothing holds the chain along x.
  model::Model model = cantilever(linear_law(1e6, 1), 1, 4);
  model.supports = {{.node = 0, .fixed = {false, true, true, true, true, true}}};
  model.loads = {{.node = 4, .force = {7, 0, 0}}};
  System system(model);
  Vector u = zeros(model);
  system.begin(u);
  std::string message;
  try {
    find_equilibrium(system, u, {});
  } catch (const ComputationError& error) {
    message = error.what();
  }
  INFO(message);
  CHECK(message.find("no static equilibrium in step 1 at load factor") != std::string::npos);
  CHECK(message.find("node") != std::string::npos);
  CHECK(message.find("displacement x") != std::string::npos);
}
