// Weights whose centre of mass lies beside their node.
#include <doctest/doctest.h>

#include "math/dense.hpp"
#include "strandyn/solver/modes/modes.hpp"
#include "strandyn/system/system.hpp"
#include "support/check_close.hpp"
#include "support/derivative.hpp"
#include "system/spans.hpp"

using namespace strandyn;
using strandyn::system::EccentricBodies;
using strandyn::system::System;
using strandyn::system::Vector;
using strandyn::test::check_close;

namespace {

constexpr double mass = 2.3;
const Eigen::Vector2d beside{-0.3, 0.2};

model::Model with_weight() {
  model::Model model = test::cantilever(test::linear_law(1e6, 10), 1, 3);
  model.bodies = {{.node = 2, .mass = mass, .inertia = 0.1, .eccentricity = beside}};
  return model;
}

Vector random_vector(const model::Model& model, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(-1, 1);
  Vector x = test::zeros(model);
  for (auto& entry : x) entry = between(random);
  return x;
}

/// [m/s] of the centre of mass, from where it is after a short time.
Eigen::Vector2d velocity_of_centre(const Vector& u, const Vector& v) {
  constexpr Eigen::Index x = 2 * 3;
  return test::derivative([&](double t) -> Eigen::Vector2d {
    const Vector at = u + t * v;
    return at.segment<2>(x) + Eigen::Rotation2Dd(at(x + 2)) * beside;
  });
}

}  // namespace

TEST_CASE("eccentric bodies: node and weight together have the kinetic energy of the centre of mass") {
  const model::Model model = with_weight();
  const EccentricBodies bodies(model);
  for (unsigned seed = 1; seed < 6; ++seed) {
    const Vector u = 3 * random_vector(model, seed), v = random_vector(model, seed + 100);
    const double at_node = mass * v.segment<2>(6).squaredNorm() / 2;
    const double whole = mass * velocity_of_centre(u, v).squaredNorm() / 2;
    check_close(at_node + bodies.kinetic_energy(u.data(), v.data()), whole, {.relative = 1e-9});
    math::ChainMatrix M(3, model.nodes.size());
    bodies.add_mass(u.data(), M);
    check_close(0.5 * v.dot(test::dense(M) * v), bodies.kinetic_energy(u.data(), v.data()), {.relative = 1e-12});
  }
}

TEST_CASE("eccentric bodies: force and tangents are those of Lagrange's equations at any rotation") {
  const model::Model model = with_weight();
  const EccentricBodies bodies(model);
  const auto n = static_cast<Eigen::Index>(model.unknowns());
  const auto force = [&](const Vector& u, const Vector& v, const Vector& a) {
    Vector f = test::zeros(model);
    bodies.add_inertia_force(u.data(), v.data(), a.data(), f.data());
    return f;
  };
  for (unsigned seed = 1; seed < 6; ++seed) {
    const Vector u = 3 * random_vector(model, seed), v = random_vector(model, seed + 100);
    const Vector a = random_vector(model, seed + 200);
    // d/dt (dT/dv) - dT/du along u + v t + a t^2/2.
    const Vector f = force(u, v, a);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Vector unit = Vector::Unit(n, i);
      const auto momentum = [&](double t) {
        const Vector ut = u + t * v + t * t / 2 * a, vt = v + t * a;
        return test::derivative([&](double h) {
          const Vector moved = vt + h * unit;
          return bodies.kinetic_energy(ut.data(), moved.data());
        });
      };
      const double by_place = test::derivative([&](double h) {
        const Vector moved = u + h * unit;
        return bodies.kinetic_energy(moved.data(), v.data());
      });
      check_close(f(i), test::derivative(momentum) - by_place, {.absolute = 1e-8});
      const auto column = [&](beam::InertiaFactors factors, const Vector& by_differences) {
        math::ChainMatrix K(3, model.nodes.size());
        bodies.add_inertia_tangent(u.data(), v.data(), a.data(), factors, K);
        CHECK((test::dense(K).col(i) - by_differences).norm() < 1e-8);
      };
      column({.acceleration = 1}, test::derivative([&](double h) -> Vector { return force(u, v, a + h * unit); }));
      column({.velocity = 1}, test::derivative([&](double h) -> Vector { return force(u, v + h * unit, a); }));
      column({.position = 1}, test::derivative([&](double h) -> Vector { return force(u + h * unit, v, a); }));
    }
  }
}

TEST_CASE("eccentric bodies: chains in space refuse them") {
  model::Model model = with_weight();
  model.freedom = model::Freedom::transverse_spatial;
  CHECK_THROWS_AS(EccentricBodies{model}, std::invalid_argument);
  model.bodies[0].eccentricity.setZero();
  CHECK_NOTHROW(EccentricBodies{model});
}

TEST_CASE("eccentric bodies: a rigid rod to the weight is the same as a weight beside its node") {
  // A nearly rigid, massless element carries the weight at its end: the frequencies are those of the offset.
  const double rod = 0.05;
  const auto lowest = [](const model::Model& model) {
    System system(model);
    const Vector rest = system.make_vector();
    system.begin(rest);
    std::vector<double> frequencies;
    for (const solver::Mode& mode : solver::find_modes(system, rest, {.count = 2}))
      frequencies.push_back(mode.frequency);
    return frequencies;
  };
  for (const model::Freedom freedom : {model::Freedom::planar, model::Freedom::transverse_planar}) {
    model::Model offset = test::cantilever(test::linear_law(1e6, 10), 1, 8);
    offset.freedom = freedom;
    offset.mass_matrix = model::MassMatrix::consistent;
    offset.inertia = {.mass = 1e-6};
    offset.bodies = {{.node = 8, .mass = mass, .inertia = 0.01, .eccentricity = {rod, 0}}};
    const std::vector<double> got = lowest(offset);
    // By hand: a massless cantilever of length l under a rigid weight at distance e beyond its end.
    constexpr double l = 1, EI = 10, J = 0.01;
    Eigen::Matrix2d K, M;
    K << 12 / (l * l * l), -6 / (l * l), -6 / (l * l), 4 / l;
    M << mass, mass * rod, mass * rod, J + mass * rod * rod;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> exact(EI * K, M);
    for (int k = 0; k < 2; ++k) {
      check_close(got[static_cast<std::size_t>(k)], std::sqrt(exact.eigenvalues()(k)) / (2 * std::numbers::pi),
                  {.relative = 1e-5});
    }
  }
}
