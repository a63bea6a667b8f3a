// Equilibrium paths that are hard: large rotations, limit points of load and of displacement, the order of Newton.
#include <doctest/doctest.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strandyn/core/error.hpp"
#include "strandyn/exact/elastica.hpp"
#include "strandyn/solver/static/equilibrium.hpp"
#include "support/check_close.hpp"
#include "system/freedoms.hpp"

using namespace strandyn;
using model::Unknown;
using strandyn::solver::Control;
using strandyn::solver::EquilibriumStep;
using strandyn::solver::find_equilibrium;
using strandyn::system::System;
using strandyn::system::Vector;
using strandyn::test::cantilever;
using strandyn::test::check_close;
using strandyn::test::linear_law;
using strandyn::test::place;
using strandyn::test::zeros;

namespace {

constexpr double pi = std::numbers::pi;

/// The corrections of one step from `u` to loads that are greater by a part.
std::vector<double> corrections(model::Model& model, System& system, Vector u, double part) {
  const std::vector<model::Load> loads = model.loads;
  for (model::Load& load : model.loads) {
    load.force *= 1 + part;
    load.moment *= 1 + part;
  }
  const auto summary = find_equilibrium(system, u, {.tolerance = 1e-13});
  model.loads = loads;
  REQUIRE(summary.steps.size() == 1);
  return summary.steps.front().corrections;
}

/// Order of convergence at a state: how the second correction falls with the first when the load step is made smaller.
/// Along one step a slender chain alternates, it stretches in one correction and recovers in the next.
double order_at(model::Model& model, System& system, const Vector& u) {
  const auto wide = corrections(model, system, u, 1e-3);
  const auto narrow = corrections(model, system, u, 1e-4);
  REQUIRE(wide.size() >= 2);
  REQUIRE(narrow.size() >= 2);
  const double order = std::log(wide[1] / narrow[1]) / std::log(wide[0] / narrow[0]);
  MESSAGE(fmt::format("order {:.3f}, corrections {:.1e}", order, fmt::join(wide, " ")));
  return order;
}

/// Two bars of 120 at a right angle, pinned at their far ends, a force down on the beam at a fifth from the corner.
/// EI/L^2 = 0.1 N. [Lee, Manuel and Rossow 1968]
model::Model lees_frame(double force) {
  model::Model model;
  std::vector<double> positions;
  for (int i = 0; i <= 40; ++i) positions.push_back(6.0 * i);
  model::lay_out(model, model::Polyline{.corners = {{0, 0, 0}, {0, 120, 0}, {120, 120, 0}}, .positions = positions});
  const std::array<bool, 6> pin = {true, true, true, true, true, false};
  model.supports = {{.node = 0, .fixed = pin}, {.node = 40, .fixed = pin}};
  model.law = linear_law(4320, 1440);
  model.inertia = {.mass = 1};
  model.loads = {{.node = 24, .force = {0, -force, 0}}};
  return model;
}

struct Point {
  double factor = 0;
  Vector u;
};

}  // namespace

TEST_CASE("equilibrium path: rolling up a cantilever by a moment Newton's corrections fall with their square") {
  for (const auto freedom : {model::Freedom::planar, model::Freedom::spatial_untwisted, model::Freedom::spatial}) {
    // In space rotation vectors longer than 4 rad would be exchanged.
    const double turn = freedom == model::Freedom::planar ? 2 * pi : 1.2 * pi;
    model::Model model = cantilever(nullptr, 1, 20);
    model.freedom = freedom;
    model.law =
        freedom == model::Freedom::planar
            ? linear_law(1e4, 1)
            : std::make_shared<section::LinearLaw>("elastic", section::Dimension::spatial,
                                                   section::LinearStiffness{.EA = 1e4, .GJ = 0.8, .C_AT = 0, .EI = 1});
    model.loads = {{.node = 20, .moment = {0, 0, turn}}};
    System system(model);
    Vector u = zeros(model);
    system.begin(u);
    const auto summary = find_equilibrium(system, u, {.steps = 6});
    MESSAGE(fmt::format("last step of {:.2f} rad: corrections {:.1e}", turn / 6,
                        fmt::join(summary.steps.back().corrections, " ")));
    check_close(u(place(model, 20, Unknown::rotation_z)), turn, {.relative = 1e-10});
    // Chords of an arc of 18 degrees each; measured below 1e-4.
    check_close(u(place(model, 20, Unknown::x)), std::sin(turn) / turn - 1, {.relative = 2e-4});
    CHECK(order_at(model, system, u) >= 1.9);
  }
}

TEST_CASE("equilibrium path: the 45 degree bend under a load out of its plane converges with the square") {
  // An eighth of a circle of radius 100, unit square section, nu = 0. [Bathe and Bolourchi 1979]
  constexpr std::size_t elements = 8;
  model::Model model;
  model.freedom = model::Freedom::spatial;
  std::vector<Eigen::Vector3d> corners;
  std::vector<double> positions;
  for (std::size_t i = 0; i <= elements; ++i) {
    const double angle = pi / 4 * static_cast<double>(i) / elements;
    corners.emplace_back(100 * std::sin(angle), 100 * (1 - std::cos(angle)), 0);
    positions.push_back(i == 0 ? 0 : positions.back() + (corners[i] - corners[i - 1]).norm());
  }
  model::lay_out(model, model::Polyline{.corners = corners, .positions = positions});
  model.supports = {{.node = 0, .fixed = {true, true, true, true, true, true}}};
  model.law = std::make_shared<section::LinearLaw>(
      "elastic", section::Dimension::spatial,
      section::LinearStiffness{.EA = 1e7, .GJ = 1e7 / 12, .C_AT = 0, .EI = 1e7 / 12});
  model.inertia = {.mass = 1};
  model.loads = {{.node = elements, .force = {0, 0, 600}}};
  System system(model);
  Vector u = zeros(model);
  system.begin(u);
  const auto summary = find_equilibrium(system, u, {.steps = 6});
  CHECK(summary.steps.size() == 6);
  const Eigen::Vector3d tip = model.nodes.back() + model.displacement(u.data(), elements);
  // [Simo and Vu-Quoc 1986], eight straight elements of their own.
  CHECK((tip - Eigen::Vector3d(47.23, 15.79, 53.37)).lpNorm<Eigen::Infinity>() <= 0.1);
  CHECK(order_at(model, system, u) >= 1.9);
}

TEST_CASE("equilibrium path: arc length leads through Lee's frame and meets displacement control after its maximum") {
  const model::Model model = lees_frame(3);
  std::vector<Point> path;
  {
    System system(model);
    Vector u = zeros(model);
    system.begin(u);
    const auto keep = [&](const EquilibriumStep& step, const Vector& at, double) {
      path.push_back({.factor = step.load_factor, .u = at});
    };
    find_equilibrium(system, u, {.steps = 200, .control = Control::arc_length, .arc_step = 25, .watch = keep});
  }
  REQUIRE(path.back().factor >= 1);
  std::size_t top = 0;
  while (path[top + 1].factor > path[top].factor) ++top;
  std::size_t bottom = top;
  while (path[bottom + 1].factor < path[bottom].factor) ++bottom;
  MESSAGE("Lee's frame: loads between " << 3 * path[top].factor << " and " << 3 * path[bottom].factor << " N, "
                                        << path.size() << " steps");
  // The published maximum is 18.55 EI/L^2; the step may miss the crest by a little.
  check_close(3 * path[top].factor, 1.855, {.relative = 0.01});
  CHECK(path[bottom].factor < -0.25);
  // Down comes the load while the point still sinks: there displacement control finds the same states.
  const auto sinks = place(model, 24, Unknown::y);
  bool snaps_back = false;
  for (std::size_t i = 1; i < bottom; ++i) snaps_back = snaps_back || path[i].u(sinks) > path[i - 1].u(sinks);
  CHECK(snaps_back);
  const Point& point = path[top + 1];
  REQUIRE(point.u(sinks) < path[top].u(sinks));
  System system(model);
  Vector u = zeros(model);
  system.begin(u);
  const auto summary =
      find_equilibrium(system, u,
                       {.steps = 12,
                        .control = Control::displacement,
                        .point = {.node = 24, .direction = -Eigen::Vector3d::UnitY(), .target = -point.u(sinks)}});
  check_close(summary.steps.back().load_factor, point.factor, {.relative = 1e-7});
  CHECK((u - point.u).lpNorm<Eigen::Infinity>() <= 1e-6);  // of 100 m
  // On the way it passed the same maximum.
  double most = 0;
  for (const EquilibriumStep& step : summary.steps) most = std::max(most, step.load_factor);
  CHECK(most > point.factor);
}

TEST_CASE("equilibrium path: under displacement control a cantilever takes the load of the elastica") {
  const double deflection = exact::cantilever_elastica({.force = 10, .EI = 1, .length = 1}).deflection;
  model::Model model = cantilever(linear_law(1e8, 1), 1, 20);
  model.loads = {{.node = 20, .force = {0, 4, 0}}};
  System system(model);
  Vector u = zeros(model);
  system.begin(u);
  const auto summary = find_equilibrium(
      system, u, {.steps = 8, .control = Control::displacement, .point = {.node = 20, .target = deflection}});
  REQUIRE(summary.steps.size() == 8);
  check_close(u(place(model, 20, Unknown::y)), deflection, {.relative = 1e-9});
  check_close(summary.steps.back().load_factor, 2.5, {.relative = 1e-4});  // tip stiffens: 2e-6 in w is 1e-5 in load
}

TEST_CASE("equilibrium path: an arc step too wide is cut and the steps grow again") {
  const model::Model model = lees_frame(1.5);
  System system(model);
  Vector u = zeros(model);
  system.begin(u);
  double longest = 0;
  double shortest = 1e9;
  Vector before = u;
  const auto measure = [&](const EquilibriumStep&, const Vector& at, double) {
    double sum = 0;
    for (Eigen::Index i = 0; i < at.size(); ++i) {
      if (!model::is_rotation(model.kind(static_cast<std::size_t>(i)))) sum += std::pow(at(i) - before(i), 2);
    }
    longest = std::max(longest, std::sqrt(sum));
    shortest = std::min(shortest, std::sqrt(sum));
    before = at;
  };
  find_equilibrium(
      system, u, {.steps = 40, .max_iterations = 5, .control = Control::arc_length, .arc_step = 300, .watch = measure});
  CHECK(longest <= 300 * (1 + 1e-6));
  CHECK(shortest <= 150 * (1 + 1e-6));
}

TEST_CASE("equilibrium path: a support that turns rolls a cantilever up and feels the moment for it") {
  model::Model model = cantilever(linear_law(1e6, 1), 1, 20);
  model.motions = {{.node = 20, .unknown = Unknown::rotation_z, .amplitude = 2 * pi}};
  System system(model);
  Vector u = zeros(model);
  system.begin(u);
  find_equilibrium(system, u, {.steps = 20});
  const auto tip = place(model, 20, Unknown::rotation_z);
  CHECK(u(tip) == 2 * pi);
  check_close(u(place(model, 20, Unknown::x)), -1, {.relative = 1e-9});
  Vector f = zeros(model);
  system.internal_force(u.data(), f.data());
  check_close(f(tip), 2 * pi, {.relative = 1e-9});
}

TEST_CASE("equilibrium path: a displacement that no load can bring about is refused by step and node") {
  model::Model model = cantilever(linear_law(1e6, 1), 1, 4);
  model.loads = {{.node = 4, .force = {0, 1, 0}}};
  System system(model);
  Vector u = zeros(model);
  system.begin(u);
  CHECK_THROWS_WITH_AS(
      find_equilibrium(system, u, {.steps = 4, .control = Control::displacement, .point = {.node = 0, .target = 0.1}}),
      doctest::Contains("no static equilibrium in step 1"), ComputationError);
}

TEST_CASE("equilibrium path: where it breaks off the message names the step and the residual with its node") {
  // Nothing holds the chain along x; the step has been halved ten times.
  model::Model model = cantilever(linear_law(1e6, 1), 1, 4);
  model.supports = {{.node = 0, .fixed = {false, true, true, true, true, true}}};
  model.loads = {{.node = 4, .force = {1024, 0, 0}}};
  System system(model);
  Vector u = zeros(model);
  system.begin(u);
  CHECK_THROWS_WITH_AS(find_equilibrium(system, u, {}), doctest::Contains(" N at node "), ComputationError);
}
