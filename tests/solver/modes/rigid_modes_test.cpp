// Chains that supports leave free to move as one piece.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "strandyn/solver/modes/modes.hpp"
#include "support/check_close.hpp"
#include "system/freedoms.hpp"

using namespace strandyn;
using model::Unknown;
using solver::Mode;
using solver::ModeKind;
using strandyn::test::check_close;
using strandyn::test::zeros;

namespace {

constexpr double length = 10, EI = 100, EA = 1e6, GJ = 80, mass = 1, polar = 0.01;
constexpr double pi = std::numbers::pi;

model::Model chain(model::Freedom freedom, std::array<bool, 6> left, std::array<bool, 6> right) {
  constexpr std::size_t elements = 40;
  model::Model model;
  model.freedom = freedom;
  std::vector<double> positions;
  for (std::size_t i = 0; i <= elements; ++i) positions.push_back(length * static_cast<double>(i) / elements);
  model::lay_out(model, model::StraightSpan{.positions = positions});
  model.supports = {{.node = 0, .fixed = left}, {.node = elements, .fixed = right}};
  const auto dimension = model::is_spatial(freedom) ? section::Dimension::spatial : section::Dimension::planar;
  model.law = std::make_shared<section::LinearLaw>("elastic", dimension,
                                                   section::LinearStiffness{.EA = EA, .GJ = GJ, .C_AT = 0, .EI = EI});
  model.inertia = {.mass = mass, .polar = polar};
  model.mass_matrix = model::MassMatrix::consistent;
  return model;
}

constexpr std::array<bool, 6> loose = {};

std::vector<Mode> modes_of(const model::Model& model, std::size_t count) {
  system::System system(model);
  system.begin(zeros(model));
  return solver::find_modes(system, zeros(model), {.count = count});
}

/// [Hz] of a free beam: cos(beta) cosh(beta) = 1.
double free_beam(int n) {
  constexpr std::array beta = {4.730040744862704, 7.853204624095838, 10.995607838001671};
  const double b = beta[static_cast<std::size_t>(n) - 1] / length;
  return b * b * std::sqrt(EI / mass) / (2 * pi);
}

std::size_t rigid_ones(const std::vector<Mode>& modes) {
  std::size_t count = 0;
  for (const Mode& mode : modes) count += mode.kind == ModeKind::rigid ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("modes of a free beam in a plane: three rigid ones at zero and those of bending") {
  const auto modes = modes_of(chain(model::Freedom::planar, loose, loose), 6);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(modes[i].kind == ModeKind::rigid);
    CHECK(modes[i].frequency == 0);
    CHECK(modes[i].number == 0);
  }
  for (int n = 1; n <= 3; ++n) {
    const Mode& mode = modes[static_cast<std::size_t>(n) + 2];
    CHECK(mode.number == static_cast<std::size_t>(n));
    check_close(mode.frequency, free_beam(n), {.relative = 1e-5});
  }
}

TEST_CASE("modes of a free beam in space: six rigid ones and every bending mode twice, then torsion") {
  const auto modes = modes_of(chain(model::Freedom::spatial, loose, loose), 15);
  CHECK(rigid_ones(modes) == 6);
  for (int n = 1; n <= 3; ++n) {
    for (std::size_t plane = 0; plane < 2; ++plane) {
      check_close(modes[4 + 2 * static_cast<std::size_t>(n) + plane].frequency, free_beam(n), {.relative = 1e-5});
    }
  }
  CHECK(modes[14].kind == ModeKind::torsional);
  check_close(modes[14].frequency, std::sqrt(GJ / polar) / (2 * length), {.relative = 1e-6});
}

TEST_CASE("modes of a beam on one pin: it turns about the pin, and nothing else is rigid") {
  constexpr std::array<bool, 6> pin = {true, true, true, true, false, false};
  const auto modes = modes_of(chain(model::Freedom::planar, pin, loose), 2);
  REQUIRE(rigid_ones(modes) == 1);
  // A rod turns about its end: its deflection grows in proportion to the distance, 1 m at the other end.
  const model::Model model = chain(model::Freedom::planar, pin, loose);
  for (const std::size_t node : {10, 40}) {
    const double y = modes[0].shape(test::place(model, node, Unknown::y));
    check_close(std::abs(y), static_cast<double>(node) / 40, {.absolute = 1e-9});
  }
  // Pinned and free: tan(beta) = tanh(beta), beta = 3.926602.
  check_close(modes[1].frequency, std::pow(3.926602312047919 / length, 2) * std::sqrt(EI / mass) / (2 * pi),
              {.relative = 1e-5});
}

TEST_CASE("modes of a held span and of a pendulum have no rigid ones") {
  constexpr std::array<bool, 6> clamp = {true, true, true, true, true, true};
  CHECK(rigid_ones(modes_of(chain(model::Freedom::spatial, clamp, loose), 3)) == 0);
}
