// The equation that a system is named for, and what its supports do.
#include <doctest/doctest.h>

#include "math/dense.hpp"
#include "strandyn/system/system.hpp"
#include "support/check_close.hpp"
#include "system/spans.hpp"

using namespace strandyn;
using strandyn::system::Matrix;
using strandyn::system::System;
using strandyn::system::Vector;
using strandyn::test::curlew_span;
using strandyn::test::RandomMotion;
using strandyn::test::zeros;

namespace {

/// Ten like elements over 6 m, and motions of a hundredth, which slip.
constexpr test::SpanOptions short_span{.length = 6, .elements = 10, .graded = false};
constexpr double slipping = 0.01;  // [m], [rad]

}  // namespace

TEST_CASE("system: the residual is inertia, drag and internal force less the external one, supports included") {
  model::Model model = curlew_span(test::return_map(), short_span);
  model.drag = 3;
  model.loads = {{.node = 4, .force = {1, 20, 0}, .history = model::Driven{}},
                 {.node = 7, .moment = {0, 0, 3}, .history = model::Constant{}}};
  System system(model);
  system.begin(zeros(model));
  RandomMotion random(11);
  for (int i = 0; i < 5; ++i) system.commit(random(system, slipping).data());
  const Vector u = random(system, slipping), v = random(system, 1), a = random(system, 10);
  const model::Drive drives[] = {{.frequency = 2, .amplitude = 0.7}};
  const system::At at{.time = 0.1, .drives = drives};
  const system::State state{.u = u.data(), .v = v.data(), .a = a.data()};

  Vector internal = zeros(model), external = internal, motion = internal, r = internal, with_tangent = internal;
  system.internal_force(u.data(), internal.data());
  system.external_force(at, u.data(), external.data());
  system.add_inertia_and_drag(state, motion.data());
  CHECK(external.norm() > 10);
  CHECK(motion.norm() > 0);
  system.residual(state, at, r.data());
  CHECK((r - (motion + internal - external)).norm() <= 1e-14 * internal.norm());
  Vector at_rest = zeros(model);
  system.residual({.u = u.data()}, at, at_rest.data());
  CHECK(at_rest == internal - external);

  Matrix K = system.make_matrix();
  const auto before = system.effort();
  system.residual(state, at, with_tangent.data(), K);
  CHECK(system.effort().evaluations - before.evaluations == 20);  // the law is asked once
  CHECK(with_tangent == r);

  Vector reactions = zeros(model);
  system.reactions(state, at, reactions.data());
  for (std::size_t i = 0; i < system.unknowns(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    CHECK(reactions(k) == (system.is_held(i) ? r(k) : 0.0));
  }
}

TEST_CASE("system: the supports of a hanging span carry its weight") {
  model::Model model = curlew_span(test::stick_law(), short_span);
  const double share = 50;  // [N] at each node between the supports
  for (std::size_t node = 1; node + 1 < model.nodes.size(); ++node) {
    model.loads.push_back({.node = node, .force = {0, -share, 0}, .dead = true});
  }
  System system(model);
  Vector u = zeros(model), r = u;
  system.begin(u);
  Matrix K = system.make_matrix();
  for (int iteration = 0; iteration < 20; ++iteration) {
    system.residual({.u = u.data()}, {.part = 0}, r.data(), K);
    for (std::size_t i = 0; i < system.unknowns(); ++i) {
      if (system.is_held(i)) r(static_cast<Eigen::Index>(i)) = 0;
    }
    system.hold(K);
    math::ChainFactors factors;
    REQUIRE(factors.factorize(K));
    factors.solve(r.data());
    u -= r;
  }
  system.reactions({.u = u.data()}, {.part = 0}, r.data());
  const std::size_t last = model.nodes.size() - 1;
  const Eigen::Vector3d left = model.displacement(r.data(), 0), right = model.displacement(r.data(), last);
  const double weight = share * static_cast<double>(last - 1);
  // What rounding leaves of the axial stiffness is the scale: 1e-10 of the tension.
  const double rounding = 1e-10 * right.norm();
  test::check_close(left.y() + right.y(), weight, {.absolute = rounding});
  test::check_close(left.x() + right.x(), 0, {.absolute = rounding});
  CHECK(right.x() > 0.9 * test::curlew_tension);
}
