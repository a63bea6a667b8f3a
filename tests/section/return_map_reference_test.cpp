// The second way: the planar return map against the plain one of plain_return_map.hpp, which shares no formula with
// it.
#include <hwy/targets.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "conductor/strands.hpp"
#include "section/battery.hpp"
#include "section/one_point.hpp"
#include "section/plain_return_map.hpp"
#include "section/random_paths.hpp"
#include "strandyn/section/return_map.hpp"
#include "support/check_close.hpp"

using strandyn::conductor::section_constants;
using strandyn::conductor::Strand;
using strandyn::section::Dimension;
using strandyn::section::Field;
using strandyn::section::PlanarReturnMap;
using strandyn::test::check_close;
using strandyn::test::check_law;
using strandyn::test::curlew;
using strandyn::test::LawDescription;
using strandyn::test::OnePoint;
using strandyn::test::PathPlan;
using strandyn::test::PlainReturnMap;
using strandyn::test::PlanarStrain;
using strandyn::test::Random;
using strandyn::test::random_paths;
using strandyn::test::random_seed;
using strandyn::test::steel_1x6;
using enum strandyn::section::Component;

namespace {

/// The largest deviations met, each over the natural size of its quantity.
struct Deviation {
  double moment = 0;
  double energy = 0;
  std::size_t commits = 0;
  std::size_t commits_swept = 0;
};

double larger(double a, double b) {
  return std::isnan(b) || b > a ? b : a;  // a NaN must not get lost
}

/// Walks both implementations along `paths`, points side by side in the library's batch.
Deviation compare(const Strand& strand, int points, const LawDescription& range, const PathPlan& plan) {
  const PlanarReturnMap law(strand, points);
  const double moment = section_constants(strand).EI_max * range.curvature;
  const std::vector<Field> path = random_paths(Dimension::planar, range, plan);
  auto history = law.start(path[0]);
  std::vector<PlainReturnMap> plain(plan.points, PlainReturnMap(strand, points));
  for (std::size_t i = 0; i < plan.points; ++i) plain[i].step({.eps = path[0][axial][i], .chi = 0});

  Deviation worst;
  Field stresses(Dimension::planar, plan.points);
  strandyn::section::StepEnergy energy(plan.points);
  for (std::size_t s = 1; s < path.size(); ++s) {
    law.respond(history, path[s], stresses, nullptr);
    const auto effort = law.commit(history, path[s], energy);
    worst.commits += effort.evaluations;
    worst.commits_swept += effort.sweeps;
    for (std::size_t i = 0; i < plan.points; ++i) {
      const auto step = plain[i].step({.eps = path[s][axial][i], .chi = path[s][bending2][i]});
      const double energy_scale = moment * range.curvature + step.stored;
      worst.moment = larger(worst.moment, std::abs(stresses[bending2][i] - step.M) / moment);
      worst.energy = larger(worst.energy, std::abs(energy.stored[i] - step.stored) / energy_scale);
      worst.energy = larger(worst.energy, std::abs(energy.dissipated[i] - step.dissipated) / energy_scale);
      worst.energy = larger(worst.energy, std::abs(energy.quadrature_error[i] - step.quadrature_error) / energy_scale);
    }
  }
  return worst;
}

constexpr LawDescription curlew_range{.curvature = 0.1, .strain = 5e-4};

/// As long as it lives, the kernels run with the given instruction set.
class ChosenTarget {
 public:
  explicit ChosenTarget(std::int64_t target) { hwy::GetChosenTarget().Update(target); }
  ~ChosenTarget() { hwy::GetChosenTarget().DeInit(); }
  ChosenTarget(const ChosenTarget&) = delete;
  ChosenTarget& operator=(const ChosenTarget&) = delete;
};

}  // namespace

TEST_CASE("return map: 200 random paths with moving tension agree with the plain implementation to rounding") {
  INFO("seed ", random_seed());
  struct Subject {
    Strand strand;
    int points;
    std::uint64_t stream;
  };
  Strand uneven = curlew();  // another friction on every surface, and one that does not rub at all
  uneven.layers[4].friction_inner = 0.9;
  uneven.layers[3].friction_inner = 0;
  uneven.layers[2].friction_inner = 0.3;
  for (const Subject& subject : {Subject{curlew(), 36, 21}, Subject{curlew({.residual_forces = false}), 36, 22},
                                 Subject{uneven, 36, 23}, Subject{steel_1x6(), 72, 24}}) {
    const Deviation worst =
        compare(subject.strand, subject.points, curlew_range, {.points = 50, .steps = 30, .stream = subject.stream});
    check_close(worst.moment, 0, {.absolute = 1e-13}, "moment");
    check_close(worst.energy, 0, {.absolute = 1e-13}, "energies");
    CHECK(worst.commits_swept > 0);
  }
}

TEST_CASE("return map: steps that need no sweep agree with the plain implementation, which always marches") {
  // Small curvatures under a tension that creeps: most steps stay within the stick range.
  const LawDescription small{.curvature = 8e-3, .strain = 5e-4};
  INFO("seed ", random_seed());
  for (bool moves : {false, true}) {
    const Deviation worst =
        compare(curlew(), 36, small, {.points = 50, .steps = 60, .axial_moves = moves, .stream = 25});
    check_close(worst.moment, 0, {.absolute = 1e-13}, "moment");
    check_close(worst.energy, 0, {.absolute = 1e-13}, "energies");
    CHECK(worst.commits_swept > 0);
    CHECK(worst.commits_swept < worst.commits / 2);
  }
}

TEST_CASE("return map: a state that is not swept slips nowhere, wherever the tension went") {
  // From random committed states, random trials around them. Where the law does not march, the plain implementation
  // must find every trial gradient within its limit.
  const Strand strand = curlew();
  const PlanarReturnMap law(strand, 36);
  INFO("seed ", random_seed());
  Random random(31);
  std::size_t stuck = 0;
  std::size_t stuck_with_less_tension = 0;
  for (int path = 0; path < 100; ++path) {
    PlanarStrain now{.eps = 5e-4 * random.between(0.2, 2), .chi = 0};
    OnePoint point(law, now);
    PlainReturnMap plain(strand, 36);
    plain.step({.eps = now.eps, .chi = 0});
    for (int s = 0; s < 8; ++s) {
      now = {.eps = now.eps * random.between(0.7, 1.3), .chi = random.between(-0.05, 0.05)};
      point.commit(now);
      point.commit(now);  // a rest: a point that slipped in its last commit has no range
      plain.step({.eps = now.eps, .chi = now.chi});
      for (int t = 0; t < 20; ++t) {
        const double width = std::pow(10, random.between(-4, -1.5));
        const PlanarStrain trial{.eps = now.eps * random.between(0.7, 1.1),
                                 .chi = now.chi + width * random.between(-1, 1)};
        if (point.respond(trial).swept) continue;
        ++stuck;
        if (trial.eps < now.eps) ++stuck_with_less_tension;
        const auto step = plain.try_step({.eps = trial.eps, .chi = trial.chi});
        REQUIRE_FALSE(step.slips);
        REQUIRE(step.dissipated == 0);
      }
    }
  }
  CHECK(stuck > 1000);
  CHECK(stuck_with_less_tension > 300);
}

TEST_CASE(
    "return map: at the committed tension the stick range is exact: what has come to rest and sticks is not swept") {
  const Strand strand = curlew();
  const PlanarReturnMap law(strand, 36);
  INFO("seed ", random_seed());
  Random random(32);
  std::size_t swept = 0;
  std::size_t stuck = 0;
  for (int path = 0; path < 100; ++path) {
    const double eps = 5e-4 * random.between(0.5, 2);
    OnePoint point(law, {.eps = eps, .chi = 0});
    PlainReturnMap plain(strand, 36);
    plain.step({.eps = eps, .chi = 0});
    bool slipped = false;  // a point that slips in a commit gets its range from the next one in which it does not
    for (int s = 0; s < 20; ++s) {
      const PlanarStrain next{.eps = eps, .chi = std::pow(10, random.between(-4, -1)) * random.between(-1, 1)};
      const auto step = plain.step({.eps = eps, .chi = next.chi});
      const bool was_swept = point.commit(next).swept;
      ++(was_swept ? swept : stuck);
      if (step.nearest > 1e-9) CHECK(was_swept == (step.slips || slipped));
      slipped = step.slips;
    }
  }
  CHECK(swept > 300);
  CHECK(stuck > 300);
}

TEST_CASE("return map: the answer is continuous across the edges of the stick range") {
  const Strand strand = curlew();
  const PlanarReturnMap law(strand, 36);
  const double EI_max = section_constants(strand).EI_max;
  INFO("seed ", random_seed());
  Random random(33);
  int edges = 0;
  for (int path = 0; path < 60; ++path) {
    const double eps = 5e-4 * random.between(0.8, 2);
    const double chi = random.between(0.01, 0.05) * (random.between(-1, 1) < 0 ? -1 : 1);
    OnePoint point(law, {.eps = eps, .chi = 0});
    point.commit({.eps = eps, .chi = chi});
    point.commit({.eps = eps, .chi = chi});  // a rest, which finds the range
    // So the state stands at one edge of its range. The other edge is found by bisection.
    const double trial_eps = eps * (path % 2 == 0 ? 1 : 0.97);
    const double turn = chi > 0 ? -1 : 1;
    double inside = 4e-3 * turn;
    double outside = 1 * turn;
    // Where the bending has opened a contact on the compression side, that side slips at once: no range.
    if (point.respond({.eps = trial_eps, .chi = chi + inside}).swept) continue;
    ++edges;
    REQUIRE(point.respond({.eps = trial_eps, .chi = chi + outside}).swept);
    for (int i = 0; i < 60; ++i) {
      const double middle = (inside + outside) / 2;
      (point.respond({.eps = trial_eps, .chi = chi + middle}).swept ? outside : inside) = middle;
    }
    const auto in = point.respond({.eps = trial_eps, .chi = chi + inside});
    const auto out = point.respond({.eps = trial_eps, .chi = chi + outside});
    check_close(out.M, in.M, {.absolute = 1e-13 * EI_max * 0.1});
  }
  CHECK(edges > 20);
}

TEST_CASE("return map: every instruction set that this machine has passes the battery and gives the plain answer") {
  const std::int64_t here = hwy::SupportedTargets();
  std::size_t tried = 0;
  for (std::uint64_t left = static_cast<std::uint64_t>(here); left != 0; left &= left - 1) {
    const auto target = static_cast<std::int64_t>(left & (~left + 1));
    const ChosenTarget chosen(target);
    const std::string name = strandyn::section::vector_target().name;
    // A set that the kernel was not compiled for runs as another one.
    if (name != hwy::TargetName(target)) continue;
    INFO(name);
    const Deviation worst = compare(curlew(), 36, curlew_range, {.points = 20, .steps = 30, .stream = 26});
    check_close(worst.moment, 0, {.absolute = 1e-13}, "moment");
    check_close(worst.energy, 0, {.absolute = 1e-13}, "energies");
    check_law(PlanarReturnMap(curlew(), 36), curlew_range);
    ++tried;
  }
  CHECK(tried > 0);
}
