#include "strandyn/solver/modes/modes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "math/dense.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/exact/tensioned_beam.hpp"
#include "support/check_close.hpp"
#include "system/spans.hpp"

using namespace strandyn;
using strandyn::solver::find_modes;
using strandyn::solver::Mode;
using strandyn::solver::transverse_modes;
using strandyn::system::System;
using strandyn::system::Vector;
using strandyn::test::check_close;
using strandyn::test::curlew_span;
using strandyn::test::dense;
using strandyn::test::SpanOptions;
using strandyn::test::zeros;

namespace {

constexpr double pi = std::numbers::pi;

exact::TensionedBeamMode exact_mode(const SpanOptions& span, int n) {
  const auto c = conductor::section_constants(test::curlew());
  // Mass and curvature count per unstressed length; the span is stretched by T/EA. At mode 12 the curvature's share is
  // 3e-5 of the frequency.
  const double stretch = 1 + span.tension / c.EA;
  return {{.tension = span.tension,
           .EI = c.EI_max * stretch,
           .mass_per_length = test::curlew_mass / stretch,
           .length = span.length},
          span.clamped ? exact::BeamEnds::clamped : exact::BeamEnds::pinned,
          n};
}

std::vector<Mode> modes_of(const SpanOptions& span, std::size_t count) {
  const model::Model model = curlew_span(test::stick_law(), span);
  System system(model);
  system.begin(zeros(model));
  return transverse_modes(system, zeros(model), count);
}

/// Largest relative error of the first `count` frequencies.
double frequency_error(const SpanOptions& span, std::size_t count) {
  const auto modes = modes_of(span, count);
  double worst = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double expected = exact_mode(span, static_cast<int>(i) + 1).frequency();
    worst = std::max(worst, std::abs(modes[i].frequency / expected - 1));
  }
  return worst;
}

/// The other way: all frequencies [Hz] from dense matrices of the unknowns that are free, massless ones condensed.
Vector dense_frequencies(const System& system, const Vector& u) {
  system::Matrix K = system.make_matrix();
  system::Matrix M = system.make_matrix();
  Vector force(u.size());
  system.internal_force(u.data(), force.data(), K);
  system.mass_matrix(u.data(), M);
  std::vector<Eigen::Index> moving;
  std::vector<Eigen::Index> massless;
  for (std::size_t i = 0; i < system.unknowns(); ++i) {
    if (system.is_held(i)) continue;
    (system.has_mass(i) ? moving : massless).push_back(static_cast<Eigen::Index>(i));
  }
  const Eigen::MatrixXd k = dense(K);
  Eigen::MatrixXd condensed = k(moving, moving);
  if (!massless.empty()) {
    const Eigen::MatrixXd inner = k(massless, massless);
    const Eigen::MatrixXd coupling = k(massless, moving);
    condensed -= coupling.transpose() * inner.ldlt().solve(coupling);
  }
  const Eigen::MatrixXd m = dense(M)(moving, moving);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(condensed, m, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().cwiseSqrt() / (2 * pi);
}

}  // namespace

TEST_CASE("modes: twelve frequencies of the clamped laboratory span agree with the tensioned beam to 0.1 percent") {
  CHECK(frequency_error({}, 12) <= 1e-3);  // measured 7e-4
  CHECK(frequency_error({.mass = model::MassMatrix::consistent}, 12) <= 1e-4);
}

TEST_CASE("modes: twelve frequencies of the pinned span agree with the tensioned beam to 0.1 percent") {
  CHECK(frequency_error({.clamped = false, .graded = false}, 12) <= 2e-4);
  CHECK(frequency_error({.clamped = false, .graded = false, .mass = model::MassMatrix::consistent}, 12) <= 2e-5);
}

TEST_CASE("modes: on equal elements frequencies converge with the fourth power of their size") {
  for (const auto mass : {model::MassMatrix::lumped, model::MassMatrix::consistent}) {
    const auto error = [&](std::size_t elements) {
      const SpanOptions span{.elements = elements, .clamped = false, .graded = false, .mass = mass};
      return std::abs(modes_of(span, 12).back().frequency / exact_mode(span, 12).frequency() - 1);
    };
    // Measured: lumped 5e-2, 1.9e-3, 8e-5; consistent 1.5e-3, 9e-5, 7e-6.
    CHECK(std::log2(error(20) / error(40)) > 3.8);
    CHECK(std::log2(error(40) / error(80)) > 3.4);  // the consistent mass takes unstretched lengths
  }
}

TEST_CASE("modes: on a coarse graded mesh the consistent mass is far better than the lumped one") {
  // Lumping is of second order where neighbours differ in size; on equal elements its errors cancel. First four modes,
  // 40 elements: 1e-2 and 7e-5.
  SpanOptions span{.elements = 40};
  const double lumped = frequency_error(span, 4);
  span.mass = model::MassMatrix::consistent;
  const double consistent = frequency_error(span, 4);
  CHECK(consistent < 2e-4);
  CHECK(lumped > 20 * consistent);
}

TEST_CASE("modes: their shapes are the tensioned beam's, scaled to one metre at the largest antinode") {
  const SpanOptions span;
  const auto modes = modes_of(span, 12);
  const model::Model model = curlew_span(test::stick_law(), span);
  for (const int n : {1, 2, 12}) {
    const Mode& mode = modes[static_cast<std::size_t>(n) - 1];
    const auto expected = exact_mode(span, n);
    CHECK(mode.shape.lpNorm<Eigen::Infinity>() >= 1);
    double sign = 0;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      const exact::ShapeAt at = expected.at(model.nodes[i].x());
      const auto y = static_cast<Eigen::Index>(3 * i + 1);
      if (sign == 0 && std::abs(at.value) > 0.5) sign = mode.shape(y) * at.value > 0 ? 1 : -1;
    }
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      const exact::ShapeAt at = expected.at(model.nodes[i].x());
      const auto y = static_cast<Eigen::Index>(3 * i + 1);
      check_close(sign * mode.shape(y), at.value, {.absolute = 0.02});
    }
    // Half of the span's mass, but for the loops at the clamps.
    check_close(mode.modal_mass, 0.5 * test::curlew_mass * 30, {.relative = 0.05});
  }
}

TEST_CASE("modes: they agree with a dense solution on a small mesh, all but the highest") {
  for (const auto& [mass, rotary] : {std::pair{model::MassMatrix::lumped, 0.0},
                                     {model::MassMatrix::lumped, 1e-3},
                                     {model::MassMatrix::consistent, 0.0}}) {
    for (const bool clamped : {true, false}) {
      const SpanOptions span{.length = 6, .elements = 7, .clamped = clamped, .mass = mass, .rotary = rotary};
      const model::Model model = curlew_span(test::stick_law(), span);
      System system(model);
      system.begin(zeros(model));
      const Vector expected = dense_frequencies(system, zeros(model));
      for (const Eigen::Index count : {Eigen::Index{1}, Eigen::Index{5}, expected.size() - 1}) {
        const auto modes = find_modes(system, zeros(model), {.count = static_cast<std::size_t>(count)});
        REQUIRE(static_cast<Eigen::Index>(modes.size()) == count);
        for (Eigen::Index i = 0; i < count; ++i) {
          // Close to the highest mode the iteration loses digits: measured 2e-9.
          check_close(modes[static_cast<std::size_t>(i)].frequency, expected(i), {.relative = 1e-8});
        }
      }
    }
  }
}

TEST_CASE("modes: shapes satisfy the equation of vibration and are orthogonal over the mass") {
  const model::Model model = curlew_span(test::return_map(), {.length = 10, .elements = 30});
  System system(model);
  const Vector u = zeros(model);
  system.begin(u);
  const auto modes = find_modes(system, u, {.count = 8});
  system::Matrix K = system.make_matrix();
  system::Matrix M = system.make_matrix();
  Vector force(u.size());
  system.internal_force(u.data(), force.data(), K);
  system.mass_matrix(u.data(), M);
  const Eigen::MatrixXd k = dense(K);
  const Eigen::MatrixXd m = dense(M);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const double omega = 2 * pi * modes[i].frequency;
    Vector residual = k * modes[i].shape - omega * omega * (m * modes[i].shape);
    for (std::size_t j = 0; j < system.unknowns(); ++j) {
      if (system.is_held(j)) residual(static_cast<Eigen::Index>(j)) = 0;
    }
    CHECK(residual.norm() <= 1e-8 * (k * modes[i].shape).norm());
    for (std::size_t j = 0; j <= i; ++j) {
      const double expected = i == j ? modes[i].modal_mass : 0;
      check_close(modes[i].shape.dot(m * modes[j].shape), expected, {.absolute = 1e-8 * modes[i].modal_mass});
    }
  }
}

TEST_CASE("modes: axial modes lie between the transverse ones and are not counted among them") {
  // First axial mode: sqrt(EA/m)/(2 L) = 81 Hz on 30 m; the 31st transverse one is at 60 Hz.
  const model::Model model = curlew_span(test::stick_law(), {.elements = 160});
  System system(model);
  system.begin(zeros(model));
  const auto all = find_modes(system, zeros(model), {.count = 45});
  const auto across = transverse_modes(system, zeros(model), 40);
  const double EA = conductor::section_constants(test::curlew()).EA;
  const double axial = std::sqrt(EA / test::curlew_mass) / 60;
  std::size_t skipped = 0;
  for (std::size_t i = 0; i < across.size(); ++i) {
    while (std::abs(all[i + skipped].frequency / across[i].frequency - 1) > 1e-9) {
      check_close(all[i + skipped].frequency, axial * static_cast<double>(skipped + 1), {.relative = 2e-3});
      ++skipped;
    }
    check_close(across[i].frequency, exact_mode({}, static_cast<int>(i) + 1).frequency(), {.relative = 1e-2});
  }
  CHECK(skipped >= 1);
}

TEST_CASE("modes: a frictional span vibrates with its sticking stiffness") {
  const model::Model model = curlew_span(test::return_map());
  System system(model);
  system.begin(zeros(model));
  const auto frictional = transverse_modes(system, zeros(model), 12);
  const auto stuck = modes_of({}, 12);
  for (std::size_t i = 0; i < 12; ++i) check_close(frictional[i].frequency, stuck[i].frequency, {.relative = 1e-9});
}

TEST_CASE("modes: more than the mesh carries are refused") {
  const model::Model model = curlew_span(test::stick_law(), {.elements = 3});
  System system(model);
  system.begin(zeros(model));
  CHECK(find_modes(system, zeros(model), {.count = 3}).size() == 3);
  CHECK_THROWS_AS(find_modes(system, zeros(model), {.count = 4}), ComputationError);  // four unknowns with mass
  CHECK(transverse_modes(system, zeros(model), 2).size() == 2);
  CHECK_THROWS_AS(transverse_modes(system, zeros(model), 3), ComputationError);
}

TEST_CASE("modes: a span under compression beyond buckling is called unstable") {
  model::Model model = curlew_span(test::stick_law());
  // Twice Euler's load of the clamped beam, 4 pi^2 EI/L^2.
  const auto c = conductor::section_constants(test::curlew());
  const double euler = 4 * pi * pi * c.EI_max / 900;
  for (auto& element : model.elements) element.length = element.span.norm() / (1 - 2 * euler / c.EA);
  System system(model);
  system.begin(zeros(model));
  CHECK_THROWS_WITH_AS(find_modes(system, zeros(model), {.count = 2}), doctest::Contains("unstable"), ComputationError);
}
