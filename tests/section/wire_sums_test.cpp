#include <cmath>
#include <memory>

#include "conductor/strands.hpp"
#include "section/random_paths.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/section/law_by_place.hpp"
#include "strandyn/section/spatial_return_map.hpp"
#include "strandyn/section/stiffened_law.hpp"
#include "support/check_close.hpp"

using namespace strandyn::section;
using strandyn::conductor::Strand;
using strandyn::test::curlew;
using strandyn::test::LawDescription;
using strandyn::test::random_paths;
using enum Component;

namespace {

const LawDescription range{.curvature = 0.1, .strain = 5e-4, .torsion = 0.05};

/// Resultants of a section out of its wires, one by one as (25), (27) and (28) have them.
struct Sums {
  double N = 0, M2 = 0, M3 = 0;
  double absolute_N = 0, absolute_M = 0;  // of the terms
};

Sums sums_over_wires(const Strand& strand, const WireState& state, double eps, double chi2, double chi3,
                     double own_stiffness) {
  const double core = strand.layers.front().EA_wire() * eps;
  Sums sums{.N = core, .M2 = own_stiffness * chi2, .M3 = own_stiffness * chi3, .absolute_N = std::abs(core)};
  sums.absolute_M = std::abs(sums.M2) + std::abs(sums.M3);
  for (std::size_t j = 1; j < strand.layers.size(); ++j) {
    const auto& layer = strand.layers[j];
    const double share = layer.wires * std::cos(layer.lay_angle) / static_cast<double>(state.theta.size());
    for (std::size_t i = 0; i < state.theta.size(); ++i) {
      const double along = share * state.whole_force(state.layers[j - 1], i);
      sums.N += along;
      sums.M2 += along * layer.helix_radius * std::sin(state.theta[i]);
      sums.M3 -= along * layer.helix_radius * std::cos(state.theta[i]);
      sums.absolute_N += std::abs(along);
      sums.absolute_M += std::abs(along) * layer.helix_radius;
    }
  }
  return sums;
}

struct States {
  std::size_t looked_at = 0, stuck = 0, partly = 0, slipping = 0;
  void count(const WireState& state) {
    std::size_t slips = 0, all = 0;
    for (const LayerState& layer : state.layers) {
      for (const bool slip : layer.slips) slips += slip ? 1 : 0;
      all += layer.slips.size();
    }
    ++looked_at;
    ++(slips == 0 ? stuck : slips == all ? slipping : partly);
  }
};

/// Random paths with moving tension and twist; then all bend until every wire slips, and a little back.
std::vector<Field> paths(Dimension dimension, std::size_t points) {
  auto path = random_paths(dimension, range, {.points = points, .steps = 60});
  for (const double bent : {20.0, 19.99}) {
    Field last = path.front();
    for (std::size_t p = 0; p < points; ++p) last[bending2][p] = bent;
    path.push_back(last);
  }
  return path;
}

/// Every point of the paths after every step. `rods` [N m^2] bends beside the strand; `keeps_bending_part`: the law's N
/// has it.
States check_sums(const Law& law, const Strand& strand, double rods = 0, bool keeps_bending_part = false) {
  const double own = strandyn::conductor::section_constants(strand).EI_min + rods;
  const bool in_space = law.dimension() == Dimension::spatial;
  constexpr std::size_t points = 19;
  const std::vector<Field> path = paths(law.dimension(), points);
  History history = law.start(path.front());
  StepEnergy energy(points);
  Field stresses(law.dimension(), points);
  States states;
  for (std::size_t step = 1; step < path.size(); ++step) {
    CAPTURE(step);
    const Field& now = path[step];
    law.commit(history, now, energy);
    law.respond(history, now, stresses, nullptr);
    for (std::size_t p = 0; p < points; ++p) {
      CAPTURE(p);
      const WireState state = law.wires(history, now, p);
      states.count(state);
      const double chi3 = in_space ? now[bending3][p] : 0;
      const Sums sums = sums_over_wires(strand, state, now[axial][p], now[bending2][p], chi3, own);
      const double expected_N = stresses[axial][p] + (keeps_bending_part ? 0 : state.N_bending);
      CHECK(std::abs(sums.N - expected_N) <= 1e-10 * sums.absolute_N);
      CHECK(std::abs(sums.M2 - stresses[bending2][p]) <= 1e-10 * sums.absolute_M);
      if (in_space) CHECK(std::abs(sums.M3 - stresses[bending3][p]) <= 1e-10 * sums.absolute_M);
    }
  }
  return states;
}

}  // namespace

TEST_CASE("wire sums: forces of the planar law make its moment and its tension in every state") {
  const Strand strand = curlew();
  for (const int points : {12, 36, 72}) {
    CAPTURE(points);
    const States states = check_sums(PlanarReturnMap(strand, points), strand);
    CHECK(states.stuck > states.looked_at / 20);
    CHECK(states.partly > states.looked_at / 20);
    CHECK(states.slipping >= 19);
  }
}

TEST_CASE("wire sums: forces of the spatial law make both moments and its tension in every state, twisted or not") {
  for (const double friction : {0.1, 0.7}) {
    const Strand strand = curlew({.friction = friction});
    for (const int points : {12, 36}) {
      CAPTURE(points);
      const States states = check_sums(SpatialReturnMap(strand, {.points = points}), strand);
      CHECK(states.partly > states.looked_at / 20);
      CHECK(states.slipping >= 19);
    }
  }
}

TEST_CASE("wire sums: a law that keeps the bending part of the axial resultants has it in its tension") {
  const Strand strand = curlew();
  check_sums(SpatialReturnMap(strand, {.points = 36, .axial_resultants = true}), strand, 0, true);
}

TEST_CASE("wire sums: with armour rods and in a line of several laws the wires make their strand's part") {
  const Strand strand = curlew();
  const double rods = 350;
  check_sums(StiffenedLaw(std::make_shared<PlanarReturnMap>(strand, 36), rods), strand, rods);
  check_sums(StiffenedLaw(std::make_shared<SpatialReturnMap>(strand, SpatialReturnMapOptions{.points = 36}), rods),
             strand, rods);
  check_sums(LawByPlace({{.law = std::make_shared<PlanarReturnMap>(strand, 36), .points = 11},
                         {.law = std::make_shared<PlanarReturnMap>(strand, 20), .points = 8}}),
             strand);
}
