#include "strandyn/section/masing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "conductor/strands.hpp"
#include "section/battery.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/conductor/contact.hpp"
#include "strandyn/section/multilinear.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using namespace strandyn::section;
using strandyn::test::check_close;
using strandyn::test::curlew;
using enum Component;

namespace {

constexpr std::size_t points = 11;  // one block and a part of one

/// The closed forms of one layer, written a second time in extended precision.
struct Layer {
  long double EI = 0;        // [N m^2]
  long double critical = 0;  // [1/m]

  long double x(long double chi) const { return std::abs(chi) / critical; }
  long double moment(long double chi) const {
    if (x(chi) <= 1) return EI * chi;
    const long double r = 1 / x(chi);
    const long double M =
        2 / std::numbers::pi_v<long double> * EI * critical * (std::sqrt(1 - r * r) + x(chi) * std::asin(r));
    return chi < 0 ? -M : M;
  }
  long double loss_per_cycle(long double amplitude) const {
    const long double y = x(amplitude);
    if (y <= 1) return 0;
    return 16 / std::numbers::pi_v<long double> * EI * critical * critical * (std::sqrt(y * y - 1) - std::acos(1 / y));
  }
};

std::vector<Layer> layers_of(const conductor::Strand& strand, double eps) {
  const auto constants = conductor::section_constants(strand);
  const auto contact = conductor::contact_forces(strand, conductor::axial_wire_forces(strand, eps, 0));
  std::vector<Layer> layers;
  for (std::size_t j = 1; j < strand.layers.size(); ++j) {
    const long double c = std::cos(strand.layers[j].lay_angle);
    const long double s = std::abs(std::sin(strand.layers[j].lay_angle));
    layers.push_back(
        {.EI = constants.EI_friction[j], .critical = contact[j].q_lim / (strand.layers[j].EA_wire() * c * c * s)});
  }
  return layers;
}

constexpr double tension_at_15_percent = 0.15 * 162.8e3;

double strain_of(const conductor::Strand& strand, double tension) {
  return tension / conductor::section_constants(strand).EA;
}

Field at(double eps, double chi, std::size_t count = 1) {
  Field strains(Dimension::planar, count);
  std::fill_n(strains[axial].begin(), count, eps);
  std::fill_n(strains[bending2].begin(), count, chi);
  return strains;
}

/// One section on its way, and the ledger of what it met.
struct Traveller {
  const Law& law;
  double eps;
  History history;
  Field stresses{Dimension::planar, 1};
  StepEnergy energy{1};
  double dissipated = 0;
  double quadrature_error = 0;

  Traveller(const Law& l, double strain) : law(l), eps(strain), history(l.start(at(strain, 0))) {}
  double moment(double chi) {
    law.respond(history, at(eps, chi), stresses, nullptr);
    return stresses[bending2][0];
  }
  void go(double chi) {
    law.commit(history, at(eps, chi), energy);
    dissipated += energy.dissipated[0];
    quadrature_error += energy.quadrature_error[0];
  }
};

struct Walk {
  std::mt19937 random{11};
  std::uniform_real_distribution<double> uniform{-1, 1};
  double chi = 0;
  double next(double step, double range) { return chi = std::clamp(chi + step * uniform(random), -range, range); }
};

}  // namespace

TEST_CASE("battery: masing") {
  const conductor::Strand strand = curlew();
  test::check_law(MasingLaw(strand), {.curvature = 0.1, .strain = strain_of(strand, tension_at_15_percent)});
}

TEST_CASE("masing: the virgin curve is the closed form of each layer") {
  const conductor::Strand strand = curlew();
  const double eps = strain_of(strand, tension_at_15_percent);
  const double EI_min = conductor::section_constants(strand).EI_min;
  const MasingLaw law(strand);
  Traveller virgin(law, eps);
  for (double chi : {0.0, 1e-12, 1e-3, 0.01, 0.0137, 0.02, 0.05, -0.03, -0.3, 1.0, 30.0, 100.0}) {
    long double M = EI_min * static_cast<long double>(chi);
    for (const Layer& layer : layers_of(strand, eps)) M += layer.moment(chi);
    check_close(virgin.moment(chi), static_cast<double>(M), {.relative = 1e-14}, fmt::format("M({})", chi));
  }
}

TEST_CASE("masing: a closed cycle loses what the closed form says, in steps of any length") {
  const conductor::Strand strand = curlew();
  const double eps = strain_of(strand, tension_at_15_percent);
  const MasingLaw law(strand);
  for (double amplitude : {0.012, 0.02, 0.05, 0.5}) {
    long double expected = 0;
    for (const Layer& layer : layers_of(strand, eps)) expected += layer.loss_per_cycle(amplitude);
    for (int half_cycle : {1, 3, 200}) {
      Traveller section(law, eps);
      for (int cycle = 0; cycle < 3; ++cycle) {
        section.dissipated = 0;
        const double from = cycle == 0 ? 0 : amplitude;
        for (int n = 1; n <= half_cycle; ++n) section.go(from - (from + amplitude) * n / half_cycle);
        for (int n = 1; n <= half_cycle; ++n) section.go(-amplitude + 2 * amplitude * n / half_cycle);
      }
      check_close(section.dissipated, static_cast<double>(expected), {.relative = 1e-12},
                  fmt::format("loss per cycle at {} in {} steps", amplitude, 2 * half_cycle));
    }
  }
}

TEST_CASE("masing: a branch after a reversal is the virgin curve at twice the scale") {
  const conductor::Strand strand = curlew();
  const double eps = strain_of(strand, tension_at_15_percent);
  const double EI_min = conductor::section_constants(strand).EI_min;
  const MasingLaw law(strand);
  Traveller virgin(law, eps);
  const auto friction = [&](double chi) { return virgin.moment(chi) - EI_min * chi; };
  Traveller section(law, eps);
  section.go(0.06);
  section.go(-0.02);
  for (double chi : {-0.019, 0.0, 0.02, 0.0599}) {
    const double M_at_turn = friction(0.06) - 2 * friction(0.04);
    check_close(section.moment(chi), EI_min * chi + M_at_turn + 2 * friction((chi + 0.02) / 2), {.absolute = 1e-12});
  }
  // Where the loop closes, the virgin curve goes on.
  for (double chi : {0.06, 0.07, 0.5}) check_close(section.moment(chi), virgin.moment(chi), {.relative = 1e-14});
  // Down again past the mirror image of the first turn: the virgin curve of the other side.
  for (double chi : {-0.06, -0.2}) check_close(section.moment(chi), virgin.moment(chi), {.relative = 1e-14});
}

TEST_CASE("masing: closed inner loops leave no trace but their loss") {
  const conductor::Strand strand = curlew();
  const double eps = strain_of(strand, tension_at_15_percent);
  const MasingLaw law(strand);
  Traveller direct(law, eps);
  Traveller winding(law, eps);
  for (double chi : {0.08, -0.05, 0.06}) direct.go(chi);
  for (double chi : {0.05, 0.01, 0.08, 0.03, 0.06, 0.04, 0.055, -0.01, 0.02, -0.05, 0.03, -0.02, 0.01, 0.0, 0.06}) {
    winding.go(chi);
  }
  CHECK(law.deepest_memory(winding.history) == law.deepest_memory(direct.history));
  for (double chi : {-0.3, -0.06, -0.04, 0.0, 0.05, 0.07, 0.09}) {
    check_close(winding.moment(chi), direct.moment(chi), {.relative = 1e-13});
  }
  check_close(winding.energy.stored[0], direct.energy.stored[0], {.relative = 1e-14});
  CHECK(winding.dissipated > direct.dissipated);
}

TEST_CASE("masing: it is the sum of its elements, one elastic-plastic spring for every angle of every layer") {
  // The second way: the multilinear law with the springs of 1000 angles, N^-2 away from the closed forms. Measured:
  // 1e-6 of the scale for the moment, 4e-6 for the energies of a step.
  const conductor::Strand strand = curlew();
  const auto constants = conductor::section_constants(strand);
  const double eps = strain_of(strand, tension_at_15_percent);
  constexpr int angles = 1000;  // of a quarter turn
  MultilinearSection section{.EA = constants.EA, .GJ = 0, .EI = constants.EI_min, .springs = {}};
  for (const Layer& layer : layers_of(strand, eps)) {
    for (int i = 0; i < angles; ++i) {
      const double cosine = std::cos((i + 0.5) * std::numbers::pi / 2 / angles);
      section.springs.push_back({.stiffness = 2 * static_cast<double>(layer.EI) * cosine * cosine / angles,
                                 .yield = static_cast<double>(layer.critical) / cosine});
    }
  }
  const MasingLaw law(strand);
  const MultilinearLaw elements(section, Dimension::planar);
  const double scale = constants.EI_max * 0.03;
  const double tolerance = 8e-6 * scale * 0.03;
  for (double step : {0.005, 0.03, 0.2}) {
    Traveller one(law, eps);
    Traveller other(elements, eps);
    Walk walk;
    for (int n = 0; n < 300; ++n) {
      const double chi = walk.next(step, 0.15);
      check_close(one.moment(chi), other.moment(chi), {.absolute = 2e-6 * scale}, "moment");
      one.go(chi);
      other.go(chi);
      check_close(one.energy.stored[0], other.energy.stored[0], {.absolute = tolerance}, "stored");
      check_close(one.energy.dissipated[0], other.energy.dissipated[0], {.absolute = tolerance}, "lost");
      check_close(one.energy.quadrature_error[0], other.energy.quadrature_error[0], {.absolute = tolerance},
                  "quadrature error");
    }
    CHECK(one.dissipated > 0.1);
  }
}

TEST_CASE("masing: stored plus dissipated equals the trapezoidal work, and nothing is ever negative") {
  const conductor::Strand strand = curlew();
  const MasingLaw law(strand);
  const double eps = strain_of(strand, tension_at_15_percent);
  for (double step : {1e-4, 3e-3, 0.03, 0.3}) {
    Walk walk;
    Field before = at(eps, 0, points);
    Field now = before;
    Field stresses_before(Dimension::planar, points);
    Field stresses = stresses_before;
    History history = law.start(before);
    StepEnergy energy(points);
    law.respond(history, before, stresses_before, nullptr);
    AlignedVector stored_before(padded(points));
    for (std::size_t i = 0; i < points; ++i) stored_before[i] = 0.5 * stresses_before[axial][i] * before[axial][i];
    for (int n = 0; n < 1000; ++n) {
      for (std::size_t i = 0; i < points; ++i) {
        walk.chi = before[bending2][i];
        now[bending2][i] = walk.next(step, 3 * step + 0.05);
        now[axial][i] = eps * (1 + 0.2 * walk.uniform(walk.random));  // moves no limit
      }
      law.respond(history, now, stresses, nullptr);
      law.commit(history, now, energy);
      for (std::size_t i = 0; i < points; ++i) {
        double work = 0;
        double scale = energy.stored[i] + stored_before[i] + energy.dissipated[i];
        for (Component c : {axial, bending2}) {
          const double part = 0.5 * (stresses[c][i] + stresses_before[c][i]) * (now[c][i] - before[c][i]);
          work += part;
          scale += std::abs(part);
        }
        const double booked = energy.stored[i] - stored_before[i] + energy.dissipated[i] - energy.quadrature_error[i];
        CHECK(std::abs(booked - work) <= 1e-14 * scale);
        CHECK(energy.dissipated[i] >= 0);
        CHECK(energy.quadrature_error[i] >= 0);
      }
      stored_before = energy.stored;
      stresses_before = stresses;
      before = now;
    }
  }
}

TEST_CASE("masing: the error that the trapezoid makes falls with the square of the step") {
  const conductor::Strand strand = curlew();
  const MasingLaw law(strand);
  const double eps = strain_of(strand, tension_at_15_percent);
  double share[2] = {};
  for (int level = 0; level < 2; ++level) {
    const int steps = 100 << level;
    Traveller section(law, eps);
    section.go(0.05);
    for (int n = 1; n <= steps; ++n) section.go(0.05 * std::cos(2 * std::numbers::pi * n / steps));
    section.dissipated = section.quadrature_error = 0;
    for (int n = 1; n <= steps; ++n) section.go(0.05 * std::cos(2 * std::numbers::pi * n / steps));
    share[level] = section.quadrature_error / section.dissipated;
  }
  check_close(share[0] / share[1], 4, {.relative = 0.1}, "ratio of the errors at half the step");
}

TEST_CASE("masing: the tangent is the difference quotient of the resultants") {
  const conductor::Strand strand = curlew();
  const MasingLaw law(strand);
  const double eps = strain_of(strand, tension_at_15_percent);
  const auto constants = conductor::section_constants(strand);
  Traveller section(law, eps);
  TangentField tangents(Dimension::planar, 1);
  Walk walk;
  for (int n = 0; n < 300; ++n) {
    const double chi = walk.next(0.03, 10);  // never clamped: at a turn itself the two sides have different slopes
    law.respond(section.history, at(eps, chi), section.stresses, &tangents);
    const double h = 1e-8;
    const double quotient = (section.moment(chi + h) - section.moment(chi - h)) / ((chi + h) - (chi - h));
    check_close(tangents(bending2, bending2)[0], quotient, {.absolute = 1e-6 * constants.EI_max});
    CHECK(tangents(bending2, axial)[0] == 0);
    section.go(chi);
  }
}

TEST_CASE("masing: a vibration that dies away is remembered whole, and a larger one wipes the memory out") {
  const conductor::Strand strand = curlew();
  const MasingLaw law(strand);
  const double eps = strain_of(strand, tension_at_15_percent);
  Traveller section(law, eps);
  Traveller virgin(law, eps);
  constexpr int cycles = 200;
  std::vector<double> turns;
  for (int n = 0; n < cycles; ++n) {
    const double amplitude = 0.1 - 0.08 * n / cycles;
    turns.insert(turns.end(), {amplitude, -amplitude * 0.9999});
  }
  for (double chi : turns) section.go(chi);
  CHECK(law.deepest_memory(section.history) == turns.size() - 1);
  // On the way out each loop is closed where it was opened: from there on only the turns before it count.
  for (std::size_t n = 2; n + 2 < turns.size(); n += 40) {
    const double between = 0.5 * (turns[n] + turns[n + 2]);
    Traveller short_life(law, eps);
    for (std::size_t i = 0; i < n + 2; ++i) short_life.go(turns[i]);
    check_close(section.moment(between), short_life.moment(between), {.relative = 1e-13});
  }
  section.go(0.2);
  CHECK(law.deepest_memory(section.history) == 0);
  check_close(section.moment(0.2), virgin.moment(0.2), {.relative = 1e-15});
}

TEST_CASE("masing: below the first slip nothing is swept, remembered or lost") {
  const conductor::Strand strand = curlew();
  const MasingLaw law(strand);
  const double eps = strain_of(strand, tension_at_15_percent);
  const double EI_max = conductor::section_constants(strand).EI_max;
  double first_slip = 1e300;
  for (const Layer& layer : layers_of(strand, eps)) {
    first_slip = std::min(first_slip, static_cast<double>(layer.critical));
  }
  for (double start : {0.0, 0.08}) {
    Traveller section(law, eps);
    section.go(start);
    // On the virgin curve the elastic range is two-sided; after a slip it lies behind.
    const double middle = start == 0 ? 0 : start - 0.99 * first_slip;
    section.go(middle);
    section.dissipated = 0;
    const std::size_t before = law.deepest_memory(section.history);
    const double M = section.moment(middle);
    for (int n = 0; n < 1000; ++n) {
      const double chi = middle + 0.98 * first_slip * std::sin(0.37 * n);
      const Effort effort = law.respond(section.history, at(eps, chi), section.stresses, nullptr);
      CHECK(effort.sweeps == 0);
      check_close(section.stresses[bending2][0], M + EI_max * (chi - middle), {.absolute = 1e-12});
      section.go(chi);
    }
    CHECK(section.dissipated == 0);
    CHECK(law.deepest_memory(section.history) == before);
  }
}

TEST_CASE("masing: without friction it is EI_min, with boundless friction EI_max, a loose layer gives no stiffness") {
  const auto constants = conductor::section_constants(curlew());
  const double eps = strain_of(curlew(), tension_at_15_percent);
  const auto moment_at = [&](const conductor::Strand& strand, double strain, double chi) {
    const MasingLaw law(strand);
    Traveller section(law, strain);
    section.go(0.5 * chi);
    section.go(-chi);
    return section.moment(chi);
  };
  check_close(moment_at(curlew({.friction = 0}), eps, 0.05), constants.EI_min * 0.05, {.relative = 1e-15});
  check_close(moment_at(curlew({.friction = 1e9}), eps, 0.05), constants.EI_max * 0.05, {.relative = 1e-14});
  conductor::Strand loose = curlew({.residual_forces = false});
  check_close(moment_at(loose, -1e-4, 0.05), constants.EI_min * 0.05, {.relative = 1e-15});
  // The outermost layer alone without friction: its limit is zero, the others go on pressing each other.
  loose = curlew();
  loose.layers.back().friction_inner = 0;
  const MasingLaw law(loose);
  Traveller section(law, eps);
  check_close(section.moment(1e-4), (constants.EI_max - constants.EI_friction.back()) * 1e-4, {.relative = 1e-14});
}

TEST_CASE("masing: evaluations are pure, the same input gives the same bytes, a closed loop repeats") {
  const conductor::Strand strand = curlew();
  const MasingLaw law(strand);
  const double eps = strain_of(strand, tension_at_15_percent);
  Traveller section(law, eps);
  Walk walk;
  for (int n = 0; n < 50; ++n) section.go(walk.next(0.03, 0.1));
  const AlignedVector remembered = section.history.data;
  const double trial = walk.next(0.03, 0.1);
  const double first = section.moment(trial);
  section.moment(-0.4);
  CHECK(section.moment(trial) == first);
  CHECK(section.history.data == remembered);
  // 1e5 turns of one cycle: not a bit of drift.
  section.go(0.05);
  for (int n = 0; n < 2; ++n) section.go(n % 2 == 0 ? -0.05 : 0.05);
  const AlignedVector once = section.history.data;
  for (int n = 0; n < 100000; ++n) section.go(n % 2 == 0 ? -0.05 : 0.05);
  CHECK(section.history.data == once);
}
