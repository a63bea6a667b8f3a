#include "../../../src/solver/time/chain_problem.hpp"

#include <doctest/doctest.h>

#include "support/check_close.hpp"
#include "support/derivative.hpp"
#include "system/spans.hpp"

using namespace strandyn;
using strandyn::solver::ChainProblem;
using strandyn::system::System;
using strandyn::system::Vector;
using strandyn::test::curlew_span;
using strandyn::test::derivative;
using strandyn::test::LawPointer;
using strandyn::test::RandomMotion;
using strandyn::test::SpanOptions;
using strandyn::test::zeros;

namespace {

constexpr double cj = 7500;  // 1.5/h at h = 0.2 ms

/// State and rates of all unknowns, u first, then v.
struct State {
  Vector y, yp;
};

State random_state(const System& system, RandomMotion& random) {
  const auto n = static_cast<Eigen::Index>(system.unknowns());
  State s{Vector(2 * n), Vector(2 * n)};
  s.y << random(system, 0.01), random(system, 1);
  s.yp << s.y.tail(n), random(system, 500);
  return s;
}

/// dF/dy + cj dF/dy' by differences.
Eigen::MatrixXd matrix_by_differences(ChainProblem& problem, const State& s, double h) {
  Eigen::MatrixXd J(s.y.size(), s.y.size());
  for (Eigen::Index j = 0; j < s.y.size(); ++j) {
    J.col(j) = derivative(
        [&](double step) {
          const Vector unit = Vector::Unit(s.y.size(), j);
          const Vector y = s.y + step * unit;
          const Vector yp = s.yp + cj * step * unit;
          Vector f(s.y.size());
          problem.residual(0, y.data(), yp.data(), f.data(), false);
          return f;
        },
        h);
  }
  return J;
}

/// Largest |J x - b| of a row over what the row adds up.
double row_error(const Eigen::MatrixXd& J, const Vector& x, const Vector& b) {
  const Vector terms = J.cwiseAbs() * x.cwiseAbs() + b.cwiseAbs();
  return ((J * x - b).cwiseAbs().array() / terms.array().max(1e-300)).maxCoeff();
}

void check_solves(LawPointer law, const SpanOptions& options, double h) {
  CAPTURE(options.rotary);
  CAPTURE(options.drag);
  const model::Model model = curlew_span(std::move(law), options);
  System system(model);
  system.begin(zeros(model));
  RandomMotion random(1);
  for (int i = 0; i < 3; ++i) system.commit(random(system, 0.01).data());
  ChainProblem problem(system);
  const State s = random_state(system, random);
  const Eigen::MatrixXd J = matrix_by_differences(problem, s, h);
  Vector f(s.y.size());
  problem.residual(0, s.y.data(), s.yp.data(), f.data(), false);
  problem.refresh(cj);
  CHECK(problem.factored_cj() == cj);

  Vector b = Vector::LinSpaced(s.y.size(), 0, 40).array().sin() + 0.1;
  for (std::size_t i = 0; i < system.unknowns(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    if (system.is_held(i)) b(at) = b(at + s.y.size() / 2) = 0;
  }
  Vector x(s.y.size());
  problem.solve(b.data(), x.data());
  // Differences are good to 1e-9 of the largest entry of a row.
  CHECK(row_error(J, x, b) <= 1e-7);
}

}  // namespace

TEST_CASE("chain problem: the solution by elimination satisfies the whole linear system") {
  for (const auto mass : {model::MassMatrix::lumped, model::MassMatrix::consistent}) {
    for (const double rotary : {0.0, 1e-3}) {
      for (const double drag : {0.0, 50.0}) {
        for (const bool clamped : {true, false}) {
          const SpanOptions options{.length = 6,
                                    .elements = 6,
                                    .clamped = clamped,
                                    .graded = false,
                                    .mass = mass,
                                    .rotary = rotary,
                                    .drag = drag};
          check_solves(test::stick_law(), options, 1e-5);
          check_solves(test::return_map(), options, 1e-7);
        }
      }
    }
  }
}

TEST_CASE("chain problem: the residual holds supports and massless velocities at zero and the rest in balance") {
  model::Model model = curlew_span(test::stick_law(), {.length = 6, .elements = 4});
  model.loads = {{.node = 2, .force = {0, 30, 0}, .history = model::Constant{}}};
  System system(model);
  system.begin(zeros(model));
  ChainProblem problem(system);
  RandomMotion random(2);
  State s = random_state(system, random);
  const auto n = static_cast<Eigen::Index>(system.unknowns());
  s.y(0) = 0.5;       // a support that has moved
  s.y(n + 5) = 0.25;  // the velocity of a rotation without mass
  Vector f(2 * n);
  problem.residual(0, s.y.data(), s.yp.data(), f.data(), false);
  CHECK(f(n) == 0.5);
  CHECK(f(5) == 0.25);
  CHECK(f(4) == s.yp(4) - s.y(n + 4));

  Vector expected(n);
  system.internal_force(s.y.data(), expected.data());
  system.add_inertia_and_drag({.u = s.y.data(), .v = s.y.data() + n, .a = s.yp.data() + n}, expected.data());
  expected(7) -= 30;
  for (Eigen::Index i = 3; i < n - 3; ++i) CHECK(f(n + i) == expected(i));
}

TEST_CASE("chain problem: evaluations leave no trace in the residual of another state") {
  const model::Model model = curlew_span(test::return_map(), {.length = 6, .elements = 6, .graded = false});
  System system(model);
  system.begin(zeros(model));
  ChainProblem problem(system);
  RandomMotion random(3);
  const State s = random_state(system, random);
  Vector first(s.y.size());
  Vector again(s.y.size());
  problem.residual(0, s.y.data(), s.yp.data(), first.data(), false);
  for (int i = 0; i < 5; ++i) {
    const State other = random_state(system, random);
    problem.residual(0, other.y.data(), other.yp.data(), again.data(), false);
    problem.refresh(cj);
  }
  problem.residual(0, s.y.data(), s.yp.data(), again.data(), false);
  CHECK(first == again);
}
