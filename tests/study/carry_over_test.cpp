// A motion on another mesh of the same chain.
#include "strandyn/span/carry_over.hpp"

#include <doctest/doctest.h>

#include "strandyn/build/span.hpp"
#include "strandyn/span/shaken_span.hpp"
#include "study/scenes.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using model::Unknown;
using test::check_close;
using test::span_scene;

namespace {

constexpr const char* sweep =
    "[[load]]\ntype = \"harmonic-force\"\nat_m = 1.25\namplitude_N = 1\nfrequency = \"mode 4\"\n"
    "[analysis]\ntype = \"sweep\"\n";

build::BuiltSpan span_of(int elements) {
  casefile::Scene scene = span_scene(sweep, {"section.law=\"masing\""});
  scene.span->elements = elements;
  return build::build_span(scene);
}

/// A cubic deflection with its slope as the rotation, and a straight stretch.
Eigen::MatrixXd cubic(const model::Model& model) {
  const std::vector<double> arc = model::arc_lengths(model);
  Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(model.unknowns()), 2);
  for (std::size_t node = 0; node < arc.size(); ++node) {
    const double s = arc[node];
    const auto at = [&](Unknown unknown) { return static_cast<Eigen::Index>(*model.index(node, unknown)); };
    motion(at(Unknown::x), 0) = 0.3 - 0.02 * s;
    motion(at(Unknown::y), 1) = s * s * (1 - 0.07 * s);
    motion(at(Unknown::rotation_z), 1) = s * (2 - 0.21 * s);
  }
  return motion;
}

}  // namespace

TEST_CASE("carry over: a cubic deflection with its slopes is the same on any mesh") {
  const build::BuiltSpan coarse = span_of(9), fine = span_of(30);
  for (const auto& [from, to] : {std::pair{&coarse, &fine}, {&fine, &coarse}}) {
    const Eigen::MatrixXd carried = span::carry_over(from->model, cubic(from->model), to->model);
    const Eigen::MatrixXd exact = cubic(to->model);
    REQUIRE(carried.rows() == exact.rows());
    CHECK((carried - exact).cwiseAbs().maxCoeff() < 1e-12 * exact.cwiseAbs().maxCoeff());
  }
}

TEST_CASE("carry over: a resonance begun at that of another mesh is the one begun at the mode") {
  const auto shaken = [](int elements, int harmonics) {
    casefile::Scene scene = span_scene(sweep, {"section.law=\"masing\""});
    scene.span->elements = elements;
    build::BuiltSpan built = build::build_span(scene);
    const build::Shaker shaker = build::find_shaker(scene, built);
    const double frequency = span::modes_across(span::SpanAtRest(built), 4).back().frequency;
    return span::ShakenSpan(std::move(built), shaker, frequency, {.harmonics = harmonics});
  };
  constexpr double amplitude = 4e-3;
  const span::ShakenSpan fine = shaken(48, 5);
  const span::ResonanceAt from_mode = fine.resonance(amplitude);
  REQUIRE(from_mode.solution.converged);
  for (const int harmonics : {3, 5}) {
    CAPTURE(harmonics);
    const span::ShakenSpan coarse = shaken(24, harmonics);
    const span::ResonanceAt begun = coarse.resonance(amplitude);
    const span::ResonanceAt carried = fine.resonance(amplitude, coarse, begun.solution.state);
    REQUIRE(carried.solution.converged);
    check_close(carried.antinode_amplitude, amplitude, {.relative = 1e-5});  // where the search ends
    // Both within that of the amplitude: the loss goes with less than its fourth power, the frequency hardly at all.
    check_close(carried.solution.loop_work, from_mode.solution.loop_work, {.relative = 8e-5});
    check_close(carried.solution.state.frequency, from_mode.solution.state.frequency, {.relative = 1e-6});
    // With as many harmonics the derivatives of the sections come along; else they are asked anew, as from the mode.
    if (harmonics == 5) CHECK(carried.effort.evaluations < from_mode.effort.evaluations);
  }
}
