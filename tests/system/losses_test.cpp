// Still air and the metal of the wires on a chain.
#include <doctest/doctest.h>

#include "math/dense.hpp"
#include "strandyn/system/system.hpp"
#include "support/check_close.hpp"
#include "system/spans.hpp"

using namespace strandyn;
using strandyn::system::Matrix;
using strandyn::system::System;
using strandyn::system::Vector;
using strandyn::test::check_close;
using strandyn::test::curlew_span;
using strandyn::test::RandomMotion;
using strandyn::test::zeros;

namespace {

constexpr test::SpanOptions short_span{.length = 6, .elements = 10, .graded = false};
const air::StillAir thick{.density = 1.2, .drag_coefficient = 1.1, .drag_per_K = 0.2};

model::Model in_air(model::Freedom freedom) {
  test::SpanOptions options = short_span;
  options.freedom = freedom;
  model::Model model = curlew_span(test::return_map(freedom), options);
  model.surroundings = {.air = thick, .diameter = 0.0317};
  return model;
}

Vector air_force(const System& system, const Vector& v) {
  Vector f = system.make_vector();
  system.air_on_chain().add_force(system.air(), v.data(), f.data());
  return f;
}

}  // namespace

TEST_CASE("air on a chain: it takes energy in every motion, and none of a motion along the axis") {
  for (const model::Freedom freedom : {model::Freedom::planar, model::Freedom::spatial}) {
    const model::Model model = in_air(freedom);
    System system(model);
    system.begin(zeros(model));
    CHECK(system.air().is_none());
    RandomMotion random(5);
    CHECK(system.air_power(random(system, 1).data()) == 0);  // nobody has said how it swings
    system.set_swing(20);
    for (int i = 0; i < 20; ++i) {
      const Vector v = random(system, 1);
      const double power = system.air_power(v.data());
      CHECK(power > 0);
      check_close(power, v.dot(air_force(system, v)), {.relative = 1e-13});
    }
    Vector along = zeros(model);
    for (std::size_t i = 0; i < system.unknowns(); ++i) {
      if (model.kind(i) == model::Unknown::x) along(static_cast<Eigen::Index>(i)) = 1;
    }
    CHECK(system.air_power(along.data()) == 0);
    CHECK(air_force(system, along).norm() == 0);
  }
}

TEST_CASE("air on a chain: a sideways translation feels the force of the whole length") {
  const model::Model model = in_air(model::Freedom::spatial);
  System system(model);
  system.begin(zeros(model));
  system.set_swing(20);
  Vector v = zeros(model);
  for (std::size_t i = 0; i < system.unknowns(); ++i) {
    if (model.kind(i) == model::Unknown::y) v(static_cast<Eigen::Index>(i)) = 0.3;
    if (model.kind(i) == model::Unknown::z) v(static_cast<Eigen::Index>(i)) = 0.4;
  }
  const air::AirForce force = air::force_at(thick, 0.0317, 20);
  check_close(system.air_power(v.data()), model.unstressed_length() * force.factor(0.5) * 0.25, {.relative = 1e-13});
  double swings = 0;
  for (double power : system.air_on_chain().swing_power_by_node(force, v.cast<std::complex<double>>())) swings += power;
  check_close(swings, model.unstressed_length() * force.power_of_sine(0.5), {.relative = 1e-13});
}

TEST_CASE("air on a chain: the matrix is the derivative of the force") {
  for (const model::Freedom freedom : {model::Freedom::planar, model::Freedom::spatial}) {
    const model::Model model = in_air(freedom);
    System system(model);
    system.begin(zeros(model));
    system.set_swing(20);
    RandomMotion random(8);
    const Vector v = random(system, 1), direction = random(system, 1);
    Matrix K = system.make_matrix();
    K.set_zero();
    system.air_on_chain().add_tangent(system.air(), v.data(), 1, K);
    Vector product = system.make_vector();
    K.multiply(direction.data(), product.data());
    const double h = 1e-6;
    const Vector difference = (air_force(system, v + h * direction) - air_force(system, v - h * direction)) / (2 * h);
    CHECK((product - difference).norm() < 1e-8 * product.norm());
  }
}

TEST_CASE("material on a chain: without a clock it is relaxed, with one it answers the time since the last commit") {
  test::SpanOptions options = short_span;
  options.material = section::branches_of(section::material_loss({1e7, 300, 2400, 2400}, 1e-2));
  const model::Model model = curlew_span(test::stick_law(), options);
  const model::Model bare = curlew_span(test::stick_law(), short_span);
  System system(model), without(bare);
  system.begin(zeros(model));
  without.begin(zeros(bare));
  RandomMotion random(2);
  const Vector u = random(system, 1e-3);
  Vector f = zeros(model), f0 = f, r = f;
  system.internal_force(u.data(), f.data());
  without.internal_force(u.data(), f0.data());
  CHECK(f == f0);
  system.residual({.u = u.data()}, {.time = 0.1}, r.data());
  CHECK(r == f0);  // a static analysis

  system.start_clock(0);
  double before = 0;
  for (const double time : {10.0, 1.0, 0.1, 1e-3, 0.0}) {  // the quicker, the stiffer
    Matrix K = system.make_matrix();
    system.residual({.u = u.data()}, {.time = time}, r.data(), K);
    const double stiffer = u.dot(r - f0);
    CHECK(stiffer > before);
    before = stiffer;
    const double h = 1e-7;
    const Vector direction = random(system, 1);
    Vector up = r, down = r, product = r;
    system.residual({.u = Vector(u + h * direction).data()}, {.time = time}, up.data());
    system.residual({.u = Vector(u - h * direction).data()}, {.time = time}, down.data());
    K.multiply(direction.data(), product.data());
    CHECK(((up - down) / (2 * h) - product).norm() < 1e-6 * product.norm());
  }
  const system::Accepted accepted = system.commit(u.data(), 0.02);
  CHECK(accepted.material > 0);
  CHECK(accepted.friction == 0);
  Vector after = f;
  system.residual({.u = u.data()}, {.time = 0.02}, after.data());
  system.residual({.u = u.data()}, {.time = 20}, r.data());
  CHECK(u.dot(after) > u.dot(r));  // it relaxes
  CHECK((r - f0).norm() < 1e-9 * f0.norm());
}
