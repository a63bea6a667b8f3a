#include "strandyn/section/multilinear.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "section/battery.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using namespace strandyn::section;
using strandyn::test::check_close;
using enum Component;

namespace {

constexpr std::size_t points = 11;  // one block and a part of one

MultilinearSection ten_springs(BendingCoupling coupling = BendingCoupling::per_axis) {
  MultilinearSection section{.EA = 40e6, .GJ = 800, .EI = 100, .springs = {}, .coupling = coupling};
  for (int i = 1; i <= 10; ++i) section.springs.push_back({.stiffness = 90, .yield = i * 1e-3});
  return section;
}

std::vector<Component> components(const Law& law) {
  if (law.dimension() == Dimension::planar) return {axial, bending2};
  return {axial, torsion, bending2, bending3};
}

/// A random walk of all strains: steps of up to `curvature_step`, held within +- 3 times the range of the springs.
class Walk {
 public:
  Walk(const Law& law, double curvature_step) : law_(law), step_(curvature_step), at_(law.dimension(), points) {}
  const Field& next() {
    for (Component c : components(law_)) {
      const bool bending = c == bending2 || c == bending3;
      for (std::size_t i = 0; i < points; ++i) {
        const double moved = at_[c][i] + (bending ? step_ : 1e-5) * uniform_(random_);
        at_[c][i] = bending ? std::clamp(moved, -0.03, 0.03) : moved;
      }
    }
    return at_;
  }

 private:
  const Law& law_;
  double step_;
  Field at_;
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

std::vector<MultilinearLaw> all_forms() {
  return {{ten_springs(), Dimension::planar},
          {ten_springs(), Dimension::spatial},
          {ten_springs(BendingCoupling::coupled), Dimension::spatial}};
}

Field planar_point(double chi) {
  Field strains(Dimension::planar, 1);
  strains[bending2][0] = chi;
  return strains;
}

}  // namespace

TEST_CASE("battery: multilinear, planar and spatial, per axis and coupled") {
  const test::LawDescription what{.curvature = 0.02, .strain = 5e-4, .torsion = 0.5};
  test::check_law(MultilinearLaw(ten_springs(), Dimension::planar), what);
  test::LawDescription four_fold = what;
  four_fold.grid_angle = std::numbers::pi / 2;
  test::check_law(MultilinearLaw(ten_springs(), Dimension::spatial), four_fold);
  test::LawDescription isotropic = what;
  isotropic.grid_angle = 0.3;
  test::check_law(MultilinearLaw(ten_springs(BendingCoupling::coupled), Dimension::spatial), isotropic);
}

TEST_CASE("multilinear: the virgin curve is the sum of the springs, kink by kink") {
  const MultilinearLaw law(ten_springs(), Dimension::planar);
  const History virgin = law.start(planar_point(0));
  Field stresses(Dimension::planar, 1);
  TangentField tangents(Dimension::planar, 1);
  for (double chi : {0.0, 0.5e-3, 1.5e-3, -4.5e-3, 9.5e-3, -0.05, 1e2}) {
    double M = 100 * chi;
    double slope = 100;
    for (int i = 1; i <= 10; ++i) {
      M += 90 * std::copysign(std::min(std::abs(chi), i * 1e-3), chi);
      slope += std::abs(chi) < i * 1e-3 ? 90 : 0;
    }
    law.respond(virgin, planar_point(chi), stresses, &tangents);
    check_close(stresses[bending2][0], M, {.relative = 1e-14}, "moment");
    check_close(tangents(bending2, bending2)[0], slope, {.relative = 1e-14}, "slope");
  }
}

TEST_CASE("multilinear: a cycle loses 4 k y (A - y) per spring that slips, in steps of any length") {
  const MultilinearLaw law(ten_springs(), Dimension::planar);
  const double A = 6.5e-3;
  double expected = 0;
  for (int i = 1; i <= 6; ++i) expected += 4 * 90 * (i * 1e-3) * (A - i * 1e-3);
  for (int steps : {4, 7, 1000}) {
    History history = law.start(planar_point(A));
    StepEnergy energy(1);
    double lost = 0;
    for (int n = 1; n <= steps; ++n) {
      // A triangle wave that meets both of its corners: down in the first half of the steps, up in the rest.
      const int down = steps / 2;
      const double chi = n <= down ? A - 2 * A * n / down : -A + 2 * A * (n - down) / (steps - down);
      law.commit(history, planar_point(chi), energy);
      lost += energy.dissipated[0];
    }
    check_close(lost, expected, {.relative = 1e-12}, "loss per cycle");
  }
}

TEST_CASE("multilinear: stored plus dissipated equals the trapezoidal work, and nothing is ever negative") {
  for (const MultilinearLaw& law : all_forms()) {
    for (double step : {1e-4, 2e-3, 2e-2}) {
      Walk walk(law, step);
      Field before(law.dimension(), points);
      Field stresses_before(law.dimension(), points);
      Field stresses(law.dimension(), points);
      History history = law.start(before);
      StepEnergy energy(points);
      AlignedVector stored_before(padded(points));
      for (int n = 0; n < 500; ++n) {
        const Field& now = walk.next();
        law.respond(history, now, stresses, nullptr);
        law.commit(history, now, energy);
        for (std::size_t i = 0; i < points; ++i) {
          double work = 0;
          double scale = energy.stored[i] + stored_before[i] + energy.dissipated[i];
          for (Component c : components(law)) {
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
}

TEST_CASE("multilinear: the tangent is the difference quotient of the resultants") {
  for (const MultilinearLaw& law : all_forms()) {
    Walk walk(law, 2e-3);
    Field plus(law.dimension(), points);
    Field minus(law.dimension(), points);
    Field stresses(law.dimension(), points);
    TangentField tangents(law.dimension(), points);
    History history = law.start(plus);
    StepEnergy energy(points);
    std::size_t compared = 0;
    std::size_t off = 0;
    for (int n = 0; n < 100; ++n) {
      const Field now = walk.next();
      law.respond(history, now, stresses, &tangents);
      for (Component column : components(law)) {
        // Small enough to cross few kinks, large enough for nine digits of the difference.
        const double h = 1e-9;
        Field there = now;
        Field back = now;
        for (std::size_t i = 0; i < points; ++i) {
          there[column][i] += h;
          back[column][i] -= h;
        }
        law.respond(history, there, plus, nullptr);
        law.respond(history, back, minus, nullptr);
        for (Component row : components(law)) {
          for (std::size_t i = 0; i < points; ++i) {
            const double quotient = (plus[row][i] - minus[row][i]) / (there[column][i] - back[column][i]);
            const double scale = tangents(row, row)[i] + tangents(column, column)[i];
            ++compared;
            if (std::abs(quotient - tangents(row, column)[i]) > 1e-6 * scale) ++off;
          }
        }
      }
      law.commit(history, now, energy);
    }
    // A kink inside the difference is met with probability 10 h/step: 0.5 in 1e5 comparisons.
    CHECK(compared > 4000);
    CHECK(off <= 1);
  }
}

TEST_CASE("multilinear: per axis is two planar laws to the byte, and coupled follows a plane like a planar law") {
  const MultilinearLaw planar(ten_springs(), Dimension::planar);
  const MultilinearLaw per_axis(ten_springs(), Dimension::spatial);
  const MultilinearLaw coupled(ten_springs(BendingCoupling::coupled), Dimension::spatial);
  const double angle = 0.7;  // of the plane of bending for the coupled law
  Walk walk(per_axis, 2e-3);
  Field p2(Dimension::planar, points);
  Field p3(Dimension::planar, points);
  Field inclined(Dimension::spatial, points);
  Field m2 = p2;
  Field m3 = p3;
  Field both(Dimension::spatial, points);
  Field tilted = both;
  History h2 = planar.start(p2);
  History h3 = h2;
  History h = per_axis.start(both);
  History hc = coupled.start(both);
  StepEnergy e2(points);
  StepEnergy e3(points);
  StepEnergy e(points);
  StepEnergy ec(points);
  for (int n = 0; n < 200; ++n) {
    const Field& now = walk.next();
    p2[bending2] = now[bending2];
    p3[bending2] = now[bending3];
    for (std::size_t i = 0; i < points; ++i) {
      inclined[bending2][i] = std::cos(angle) * now[bending2][i];
      inclined[bending3][i] = std::sin(angle) * now[bending2][i];
    }
    planar.respond(h2, p2, m2, nullptr);
    planar.respond(h3, p3, m3, nullptr);
    per_axis.respond(h, now, both, nullptr);
    coupled.respond(hc, inclined, tilted, nullptr);
    planar.commit(h2, p2, e2);
    planar.commit(h3, p3, e3);
    per_axis.commit(h, now, e);
    coupled.commit(hc, inclined, ec);
    CHECK(both[bending2] == m2[bending2]);
    CHECK(both[bending3] == m3[bending2]);
    for (std::size_t i = 0; i < points; ++i) {
      check_close(e.dissipated[i], e2.dissipated[i] + e3.dissipated[i], {.relative = 1e-15});
      // Rounding of the inclined walk, 1e-17 1/m a step, times EI.
      check_close(tilted[bending2][i], std::cos(angle) * m2[bending2][i], {.absolute = 1e-11});
      check_close(tilted[bending3][i], std::sin(angle) * m2[bending2][i], {.absolute = 1e-11});
      check_close(ec.dissipated[i], e2.dissipated[i], {.absolute = 1e-14});
    }
  }
}

TEST_CASE("multilinear: coupled springs turn with the path, by any angle") {
  const MultilinearLaw law(ten_springs(BendingCoupling::coupled), Dimension::spatial);
  const double c = std::cos(0.4321);
  const double s = std::sin(0.4321);
  Walk walk(law, 2e-3);
  Field turned(Dimension::spatial, points);
  Field M = turned;
  Field M_turned = turned;
  History history = law.start(turned);
  History history_turned = history;
  StepEnergy energy(points);
  for (int n = 0; n < 200; ++n) {
    const Field& now = walk.next();
    for (std::size_t i = 0; i < points; ++i) {
      turned[bending2][i] = c * now[bending2][i] - s * now[bending3][i];
      turned[bending3][i] = s * now[bending2][i] + c * now[bending3][i];
    }
    law.respond(history, now, M, nullptr);
    law.respond(history_turned, turned, M_turned, nullptr);
    for (std::size_t i = 0; i < points; ++i) {
      check_close(M_turned[bending2][i], c * M[bending2][i] - s * M[bending3][i], {.absolute = 1e-11});
      check_close(M_turned[bending3][i], s * M[bending2][i] + c * M[bending3][i], {.absolute = 1e-11});
    }
    law.commit(history, now, energy);
    law.commit(history_turned, turned, energy);
  }
}

TEST_CASE("multilinear: on a circular orbit a coupled spring trails behind and loses 2 pi k y sqrt(A^2 - y^2) a turn") {
  // The slip point is drawn along the stretch, which in the steady state is tangent to the slip point's own circle.
  const double k = 90;
  const double y = 1e-3;
  const double A = 2e-3;
  const MultilinearLaw law(
      {.EA = 1, .GJ = 1, .EI = 0, .springs = {{.stiffness = k, .yield = y}}, .coupling = BendingCoupling::coupled},
      Dimension::spatial);
  const double exact = 2 * std::numbers::pi * k * y * std::sqrt(A * A - y * y);
  double error[2] = {};
  for (int level = 0; level < 2; ++level) {
    const int steps = 500 << level;
    Field at(Dimension::spatial, 1);
    at[bending2][0] = A;
    History history = law.start(at);
    StepEnergy energy(1);
    double lost = 0;
    for (int n = 1; n <= 3 * steps; ++n) {
      at[bending2][0] = A * std::cos(2 * std::numbers::pi * n / steps);
      at[bending3][0] = A * std::sin(2 * std::numbers::pi * n / steps);
      law.commit(history, at, energy);
      if (n > 2 * steps) lost += energy.dissipated[0];
    }
    error[level] = std::abs(lost / exact - 1);
  }
  CHECK(error[0] < 5e-3);  // implicit Euler at 500 steps a turn
  CHECK(error[1] < 0.6 * error[0]);
}

TEST_CASE("multilinear: evaluations are pure, the same input gives the same bytes, a closed loop repeats") {
  const std::vector<MultilinearLaw> forms = all_forms();
  for (const MultilinearLaw& law : forms) {
    Walk walk(law, 2e-3);
    const Field start(law.dimension(), points);
    History history = law.start(start);
    StepEnergy energy(points);
    Field first(law.dimension(), points);
    Field second = first;
    for (int n = 0; n < 20; ++n) law.commit(history, walk.next(), energy);
    const AlignedVector remembered = history.data;
    const Field trial = walk.next();
    law.respond(history, trial, first, nullptr);
    law.respond(history, walk.next(), second, nullptr);
    law.respond(history, trial, second, nullptr);
    CHECK(history.data == remembered);
    for (Component c : components(law)) CHECK(first[c] == second[c]);

    // Twice the same loop, out and back to where it began: the second passes through the same states.
    std::vector<Field> loop;
    for (int n = 0; n < 30; ++n) loop.push_back(walk.next());
    History state;
    for (int round = 0; round < 3; ++round) {
      for (const Field& at : loop) law.commit(history, at, energy);
      if (round == 1) state = history;
    }
    // A spring that slips forgets what was before, one that does not is where it was; the bound is the rounding of
    // 30 additions. Coupled springs only tend to a cycle, round by round.
    if (&law == &forms.back()) continue;
    for (std::size_t i = 0; i < state.data.size(); ++i) {
      check_close(history.data[i], state.data[i], {.absolute = 1e-16});
    }
  }
}

TEST_CASE("multilinear: a section that makes no sense is refused in words") {
  CHECK_FALSE(find_fault(ten_springs()));
  MultilinearSection section = ten_springs();
  section.springs[2].yield = 0;
  REQUIRE(find_fault(section));
  CHECK(find_fault(section)->find("spring 3: yield") != std::string::npos);
  section = ten_springs();
  section.springs[0].stiffness = -1;
  CHECK(find_fault(section)->find("spring 1: stiffness") != std::string::npos);
  section = ten_springs();
  section.EA = 0;
  CHECK(find_fault(section)->find("EA") != std::string::npos);
}
