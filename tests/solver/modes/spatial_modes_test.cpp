// Modes in space: pairs of equal frequency, kinds, and modes near a frequency.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/dense.hpp"
#include "strandyn/solver/modes/modes.hpp"
#include "support/check_close.hpp"
#include "system/freedoms.hpp"

using namespace strandyn;
using model::Freedom;
using model::Unknown;
using strandyn::solver::find_modes;
using strandyn::solver::Mode;
using strandyn::solver::ModeKind;
using strandyn::system::System;
using strandyn::system::Vector;
using strandyn::test::check_close;
using strandyn::test::curlew_span;
using strandyn::test::dense;
using strandyn::test::place;
using strandyn::test::SpanOptions;
using strandyn::test::zeros;

namespace {

std::vector<Mode> modes_of(const model::Model& model, const solver::ModeOptions& options) {
  System system(model);
  system.begin(zeros(model));
  return find_modes(system, zeros(model), options);
}

/// Largest displacement of any node in the direction. [m]
double reach(const model::Model& model, const Mode& mode, Unknown direction) {
  double largest = 0;
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    largest = std::max(largest, std::abs(mode.shape(place(model, node, direction))));
  }
  return largest;
}

/// A span whose torsion does not feel the tension.
model::Model rod(double GJ, const SpanOptions& options) {
  const auto c = conductor::section_constants(test::curlew());
  return curlew_span(
      std::make_shared<section::LinearLaw>("elastic", section::Dimension::spatial,
                                           section::LinearStiffness{.EA = c.EA, .GJ = GJ, .C_AT = 0, .EI = c.EI_max}),
      options);
}

}  // namespace

TEST_CASE("modes: those nearest to a frequency are those of the whole list") {
  const model::Model model = curlew_span(test::stick_law(), {.elements = 40});
  const auto all = modes_of(model, {.count = 24});
  for (const std::size_t middle : {5, 9, 18}) {
    const double near = all[middle].frequency * 1.01;
    std::vector<double> expected;
    for (const Mode& mode : all) expected.push_back(mode.frequency);
    std::sort(expected.begin(), expected.end(),
              [&](double f, double g) { return std::abs(f * f - near * near) < std::abs(g * g - near * near); });
    expected.resize(3);
    std::sort(expected.begin(), expected.end());
    const auto found = modes_of(model, {.count = 3, .near = near});
    REQUIRE(found.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) check_close(found[i].frequency, expected[i], {.relative = 1e-9});
  }
}

TEST_CASE("modes: a span in space has every mode of the plane twice, one in it and one out of it") {
  for (const Freedom freedom : {Freedom::spatial, Freedom::spatial_untwisted, Freedom::transverse_spatial}) {
    for (const auto mass : {model::MassMatrix::lumped, model::MassMatrix::consistent}) {
      CAPTURE(static_cast<int>(freedom));
      const SpanOptions options{.elements = 30, .mass = mass, .rotary = 1e-4};
      SpanOptions spatial = options;
      spatial.freedom = freedom;
      const auto flat = modes_of(curlew_span(test::stick_law(), options), {.count = 8});
      // Without torque: that of a strand under tension mixes the planes by some 1e-4.
      const model::Model model = rod(400, spatial);
      // Torsional modes of this light rotary inertia lie far above.
      for (const std::size_t count : {16, 15, 1, 2}) {
        const auto modes = modes_of(model, {.count = count});
        REQUIRE(modes.size() == count);
        for (std::size_t i = 0; i < count; ++i) {
          const bool in_plane = i % 2 == 0;
          check_close(modes[i].frequency, flat[i / 2].frequency, {.relative = 1e-6});
          CHECK(modes[i].kind == (in_plane ? ModeKind::in_plane : ModeKind::out_of_plane));
          CHECK(reach(model, modes[i], in_plane ? Unknown::z : Unknown::y) <= 1e-6);
          check_close(reach(model, modes[i], in_plane ? Unknown::y : Unknown::z), 1, {.relative = 1e-12});
          check_close(modes[i].modal_mass, flat[i / 2].modal_mass, {.relative = 1e-5});
        }
      }
    }
  }
}

TEST_CASE("modes: pairs of equal frequency are orthogonal over the mass, the rest too") {
  const model::Model model =
      curlew_span(test::stick_law(Freedom::spatial), {.elements = 30, .rotary = 1e-4, .freedom = Freedom::spatial});
  System system(model);
  const Vector u = zeros(model);
  system.begin(u);
  const auto modes = find_modes(system, u, {.count = 20});
  system::Matrix M = system.make_matrix();
  system.mass_matrix(u.data(), M);
  const Eigen::MatrixXd m = dense(M);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const double scale = std::sqrt(modes[i].modal_mass * modes[j].modal_mass);
      check_close(modes[i].shape.dot(m * modes[j].shape), i == j ? scale : 0, {.absolute = 1e-6 * scale});
    }
  }
}

TEST_CASE("modes: torsional ones are those of a rod and scaled to one radian") {
  // f_n = n sqrt(GJ/J_p)/(2 L); lumped inertia: (2/h) sin instead of the wave number.
  const double polar = 2e-3;
  const double GJ = 400;
  const model::Model model =
      rod(GJ, {.length = 10, .elements = 40, .graded = false, .rotary = polar / 2, .freedom = Freedom::spatial});
  const auto modes = modes_of(model, {.count = 30});
  const double h = model.elements.front().length;
  int n = 0;
  for (const Mode& mode : modes) {
    if (mode.kind != ModeKind::torsional) continue;
    ++n;
    const double angle = n * std::numbers::pi / 80;
    const double expected = std::sqrt(GJ / polar) * 2 / h * std::sin(angle) / (2 * std::numbers::pi);
    check_close(mode.frequency, expected, {.relative = 1e-8});
    check_close(reach(model, mode, Unknown::rotation_x), 1, {.relative = 1e-9});
    const double inertia = polar * model.unstressed_length() / 2;
    if (n == 1) check_close(mode.modal_mass, inertia, {.relative = 1e-6});
  }
  CHECK(n >= 2);
}

TEST_CASE("modes: axial ones are told from those across and found near their frequency") {
  const SpanOptions options{.length = 10, .elements = 40, .graded = false, .freedom = Freedom::spatial_untwisted};
  const model::Model model = rod(1, options);
  const auto c = conductor::section_constants(test::curlew());
  const double h = model.elements.front().length;
  const double exact =
      std::sqrt(c.EA / test::curlew_mass) * 2 / h * std::sin(std::numbers::pi / 80) / (2 * std::numbers::pi);
  const auto modes = modes_of(model, {.count = 5, .near = 1.001 * exact});
  const auto axial = std::count_if(modes.begin(), modes.end(), [](const Mode& m) { return m.kind == ModeKind::axial; });
  REQUIRE(axial == 1);
  for (const Mode& mode : modes) {
    if (mode.kind != ModeKind::axial) continue;
    check_close(mode.frequency, exact, {.relative = 1e-8});
    check_close(reach(model, mode, Unknown::x), 1, {.relative = 1e-12});
  }
}

TEST_CASE(
    "modes: slices of many modes are those of one space, pairs of both planes included, and carry their numbers") {
  for (const Freedom freedom : {Freedom::planar, Freedom::spatial}) {
    CAPTURE(static_cast<int>(freedom));
    const model::Model model =
        curlew_span(test::stick_law(freedom), {.length = 10, .elements = 200, .freedom = freedom});
    // These go by slices; those about a frequency must be the ones of their numbers.
    const std::vector<Mode> many = modes_of(model, {.count = 80});
    REQUIRE(many.size() == 80);
    for (const double near : {many[10].frequency, many[40].frequency, many[70].frequency}) {
      for (const Mode& mode : modes_of(model, {.count = 14, .near = near})) {
        REQUIRE(mode.number <= 80);
        check_close(many[mode.number - 1].frequency, mode.frequency, {.relative = 1e-9});
      }
    }
    for (std::size_t i = 0; i < many.size(); ++i) CHECK(many[i].number == i + 1);
    // Orthogonal with respect to mass: none stands for another.
    System system(model);
    system.begin(zeros(model));
    system::Matrix M = system.make_matrix();
    system.mass_matrix(zeros(model).data(), M);
    for (std::size_t i = 1; i < many.size(); ++i) {
      Vector product = zeros(model);
      M.multiply(many[i].shape.data(), product.data());
      for (const std::size_t j : {i - 1, i > 1 ? i - 2 : 0}) {
        if (j == i) continue;
        const double overlap = many[j].shape.dot(product) / std::sqrt(many[i].modal_mass * many[j].modal_mass);
        CHECK(std::abs(overlap) < 1e-6);
      }
    }
  }
}
