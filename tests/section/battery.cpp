#include "section/battery.hpp"

#include <cstring>
#include <initializer_list>
#include <limits>
#include <numbers>

#include "section/random_paths.hpp"
#include "support/check_close.hpp"

namespace strandyn::test {
namespace {

using namespace section;
using enum Component;

constexpr Component every_component[] = {axial, torsion, bending2, bending3};
constexpr double rounding = std::numeric_limits<double>::epsilon();

std::vector<Component> components_of(const Law& law) {
  std::vector<Component> list;
  for (Component c : every_component) {
    if (carries(law.dimension(), c)) list.push_back(c);
  }
  return list;
}

bool same_bytes(const AlignedVector& a, const AlignedVector& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

/// The largest offence of a check and where it happened: one message instead of thousands.
struct Worst {
  double value = 0;
  std::string where = "nowhere";

  template <class Describe>
  void see(double candidate, Describe describe) {
    if (std::isfinite(candidate) && candidate <= value) return;
    if (!std::isfinite(value)) return;
    value = candidate;
    where = describe();
  }
};

/// One law on its way: committed history and what the last accepted state answered.
struct Walk {
  const Law& law;
  History history;
  Field strains, stresses;
  StepEnergy energy;
  AlignedVector stored_before;

  Walk(const Law& the_law, const Field& start)
      : law(the_law),
        history(law.start(start)),
        strains(start),
        stresses(law.dimension(), start.points()),
        energy(start.points()) {
    law.respond(history, strains, stresses, nullptr);
    // Accepting the start once more costs nothing and tells its stored energy.
    law.commit(history, strains, energy);
  }

  void step(const Field& to) {
    law.respond(history, to, stresses, nullptr);
    stored_before = energy.stored;
    law.commit(history, to, energy);
    strains = to;
  }
};

Field shifted(const Field& field, Component only, double value) {
  Field moved = field;
  for (std::size_t i = 0; i < field.points(); ++i) moved[only][i] += value;
  return moved;
}

/// The points `indices` of a field, in that order.
Field pick(const Field& from, Dimension dimension, const std::vector<std::size_t>& indices) {
  Field to(dimension, indices.size());
  for (Component c : every_component) {
    for (std::size_t i = 0; carries(dimension, c) && i < indices.size(); ++i) to[c][i] = from[c][indices[i]];
  }
  return to;
}

double stick_stiffness(const Law& law, const LawDescription& what) {
  Field rest(law.dimension(), 1);
  rest[axial][0] = what.strain;
  Field stresses(law.dimension(), 1);
  TangentField tangents(law.dimension(), 1);
  law.respond(law.start(rest), rest, stresses, &tangents);
  return tangents(bending2, bending2)[0];
}

std::string at(std::size_t point, std::size_t step) {
  return fmt::format("point {}, step {}, seed {}", point, step, random_seed());
}

void check_energies(const Law& law, const LawDescription& what, bool axial_moves) {
  INFO("axial strain and torsion ", axial_moves ? "moving" : "held");
  const PathPlan plan{.points = 1000, .steps = 40, .axial_moves = axial_moves, .stream = axial_moves ? 1u : 2u};
  const std::vector<Field> path = random_paths(law.dimension(), what, plan);
  const std::vector<Component> components = components_of(law);
  Walk walk(law, path[0]);
  Worst gain, negative_error, imbalance;
  double lost = 0;
  for (std::size_t s = 1; s < path.size(); ++s) {
    const Field before = walk.strains;
    const Field resisted = walk.stresses;
    walk.step(path[s]);
    for (std::size_t i = 0; i < plan.points; ++i) {
      double work = 0;
      double absolute = 0;
      for (Component c : components) {
        const double part = (resisted[c][i] + walk.stresses[c][i]) / 2 * (path[s][c][i] - before[c][i]);
        work += part;
        absolute += std::abs(part);
      }
      const double D = walk.energy.dissipated[i];
      const double E_quad = walk.energy.quadrature_error[i];
      const double change = walk.energy.stored[i] - walk.stored_before[i];
      // The stored energy is a sum over layers and angles, known to a few dozen units in its last place; its change
      // cannot be known better.
      const double noise = 32 * rounding * (walk.energy.stored[i] + walk.stored_before[i]);
      const double allowed = 1e-12 * (absolute + std::abs(change) + D + E_quad) + noise;
      const auto here = [&] { return at(i, s); };
      gain.see(-D, here);
      negative_error.see(-E_quad, here);
      imbalance.see(std::abs(change + D - E_quad - work) / allowed, here);
      lost += D;
    }
  }
  CHECK_MESSAGE(gain.value <= 0, "friction gives energy: ", gain.value, " J/m at ", gain.where);
  CHECK_MESSAGE(negative_error.value <= 0, "E_quad below zero by ", negative_error.value, " at ", negative_error.where);
  CHECK_MESSAGE(imbalance.value <= 1, "work is off by ", imbalance.value, " of what is allowed, at ", imbalance.where);
  if (what.linear) {
    CHECK(lost == 0);
  } else {
    CHECK(lost > 0);
  }
}

}  // namespace

void check_law(const Law& law, const LawDescription& what) {
  INFO("law ", std::string(law.name()));
  check_zero_at_zero(law, what);
  check_tangent(law, what);
  check_energies(law, what);
  check_purity(law, what);
  check_neighbours(law, what);
  check_closed_loop(law, what);
  if (what.grid_angle != 0) check_rotation(law, what);
}

void check_zero_at_zero(const Law& law, const LawDescription& what) {
  for (const double strain : {0.0, what.strain}) {
    Field rest(law.dimension(), 3);
    std::fill_n(rest[axial].begin(), 3, strain);
    Walk walk(law, rest);
    walk.step(rest);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(walk.stresses[bending2][i] == 0);
      CHECK(walk.energy.dissipated[i] == 0);
      CHECK(walk.energy.quadrature_error[i] == 0);
      if (law.dimension() == Dimension::spatial) CHECK(walk.stresses[bending3][i] == 0);
      if (strain != 0) continue;
      CHECK(walk.stresses[axial][i] == 0);
      CHECK(walk.energy.stored[i] == 0);
      if (law.dimension() == Dimension::spatial) CHECK(walk.stresses[torsion][i] == 0);
    }
  }
}

void check_tangent(const Law& law, const LawDescription& what) {
  const PathPlan plan{.points = 300, .steps = 25, .stream = 3};
  const std::vector<Field> path = random_paths(law.dimension(), what, plan);
  Walk walk(law, path[0]);
  for (std::size_t s = 1; s + 1 < path.size(); ++s) walk.step(path[s]);
  const Field& trial = path.back();

  const std::size_t n = plan.points;
  Field middle(law.dimension(), n), ahead(law.dimension(), n), behind(law.dimension(), n);
  TangentField tangents(law.dimension(), n);
  law.respond(walk.history, trial, middle, &tangents);

  // Entries are measured by the moment of the stick stiffness over the ranges of the strains.
  const double moment = stick_stiffness(law, what) * what.curvature;
  const auto range = [&](Component c) {
    return c == axial ? what.strain : c == torsion ? what.torsion : what.curvature;
  };
  std::size_t at_kinks = 0;
  std::size_t checked = 0;
  Worst off;
  for (Component column : components_of(law)) {
    // Between two kinks of the response this step is short enough to be straight, and long enough for nine digits.
    const double h = 1e-7 * range(column);
    REQUIRE(h > 0);
    const Field plus = shifted(trial, column, h);
    const Field minus = shifted(trial, column, -h);
    law.respond(walk.history, plus, ahead, nullptr);
    law.respond(walk.history, minus, behind, nullptr);
    for (Component row : components_of(law)) {
      for (std::size_t i = 0; i < n; ++i) {
        const double forward = plus[column][i] - trial[column][i];
        const double backward = trial[column][i] - minus[column][i];
        const double slope_ahead = (ahead[row][i] - middle[row][i]) / forward;
        const double slope_behind = (middle[row][i] - behind[row][i]) / backward;
        const double quotient = (ahead[row][i] - behind[row][i]) / (forward + backward);
        const double entry = tangents(row, column)[i];
        const double scale = std::abs(entry) + (row == axial ? 0 : moment / range(column));
        // An entry of the axial row that is zero has only the rounding of N to be compared with.
        const double noise = 4 * rounding * std::abs(middle[row][i]) / h;
        ++checked;
        if (std::abs(slope_ahead - slope_behind) > 1e-6 * (scale + std::abs(quotient)) + 2 * noise) {
          ++at_kinks;
          continue;
        }
        off.see(std::abs(entry - quotient) / (1e-6 * scale + noise), [&] {
          return fmt::format("d(resultant {})/d(strain {}) = {:.9g}, quotient {:.9g}, {}", static_cast<int>(row),
                             static_cast<int>(column), entry, quotient, at(i, plan.steps));
        });
      }
    }
  }
  CHECK_MESSAGE(off.value <= 1, off.where);
  CHECK_MESSAGE(at_kinks * 50 <= checked, at_kinks, " of ", checked, " entries lie at kinks: too many to be by chance");
}

void check_energies(const Law& law, const LawDescription& what) {
  check_energies(law, what, false);
  check_energies(law, what, true);
}

void check_purity(const Law& law, const LawDescription& what) {
  const PathPlan plan{.points = 60, .steps = 30, .stream = 4};
  const std::vector<Field> path = random_paths(law.dimension(), what, plan);
  const std::vector<Field> trials = random_paths(law.dimension(), what, {.points = 60, .steps = 30, .stream = 5});
  Walk plain(law, path[0]);
  Walk tried(law, path[0]);
  Field trial_stresses(law.dimension(), plan.points), after(law.dimension(), plan.points);
  TangentField tangents(law.dimension(), plan.points);
  const double moment = stick_stiffness(law, what) * what.curvature;
  Worst jump, loss;
  for (std::size_t s = 1; s < path.size(); ++s) {
    const AlignedVector before = tried.history.data;
    for (std::size_t t : {s, s - 1}) law.respond(tried.history, trials[t], trial_stresses, &tangents);
    REQUIRE(same_bytes(tried.history.data, before));

    plain.step(path[s]);
    tried.step(path[s]);
    REQUIRE(same_bytes(plain.history.data, tried.history.data));
    for (Component c : components_of(law)) REQUIRE(same_bytes(plain.stresses[c], tried.stresses[c]));
    REQUIRE(same_bytes(plain.energy.stored, tried.energy.stored));
    REQUIRE(same_bytes(plain.energy.dissipated, tried.energy.dissipated));
    REQUIRE(same_bytes(plain.energy.quadrature_error, tried.energy.quadrature_error));

    law.respond(plain.history, path[s], after, nullptr);
    StepEnergy again(plan.points);
    History copy = plain.history;
    law.commit(copy, path[s], again);
    for (std::size_t i = 0; i < plan.points; ++i) {
      for (Component c : components_of(law)) {
        const double scale = c == axial ? std::abs(plain.stresses[c][i]) + moment * what.curvature : moment;
        jump.see(std::abs(after[c][i] - plain.stresses[c][i]) / scale, [&] { return at(i, s); });
      }
      loss.see(again.dissipated[i] / (moment * what.curvature), [&] { return at(i, s); });
    }
  }
  CHECK_MESSAGE(jump.value <= 1e-12, "an accepted state answers otherwise by ", jump.value, " at ", jump.where);
  CHECK_MESSAGE(loss.value <= 1e-13, "accepting a state twice loses ", loss.value, " at ", loss.where);
}

void check_neighbours(const Law& law, const LawDescription& what) {
  const PathPlan plan{.points = 160, .steps = 30, .stream = 6};
  const std::vector<Field> path = random_paths(law.dimension(), what, plan);
  const std::vector<Component> components = components_of(law);
  const double moment = stick_stiffness(law, what) * what.curvature;
  Worst off_with_tangent;
  constexpr std::size_t subjects[] = {0, 5, 77, 159};
  for (std::size_t subject : subjects) {
    std::vector<std::size_t> everybody;
    for (std::size_t i = 0; i < plan.points; ++i) everybody.push_back(i);
    struct Company {
      std::vector<std::size_t> points;
      std::size_t place;
    };
    const std::vector<Company> companies = {
        {{subject}, 0}, {{11, subject, 42}, 1}, {{90, 91, 92, 93, 94, 95, subject, 96}, 6}, {everybody, subject}};
    std::vector<Walk> walks;
    for (const Company& company : companies) {
      walks.emplace_back(law, pick(path[0], law.dimension(), company.points));
    }
    for (std::size_t s = 1; s < path.size(); ++s) {
      std::vector<std::vector<double>> answers;
      for (std::size_t w = 0; w < walks.size(); ++w) {
        const Field to = pick(path[s], law.dimension(), companies[w].points);
        const std::size_t place = companies[w].place;
        TangentField tangents(law.dimension(), to.points());
        Field with_tangent(law.dimension(), to.points());
        law.respond(walks[w].history, to, with_tangent, &tangents);
        walks[w].step(to);
        std::vector<double> answer = {walks[w].energy.stored[place], walks[w].energy.dissipated[place],
                                      walks[w].energy.quadrature_error[place]};
        for (Component row : components) {
          answer.push_back(walks[w].stresses[row][place]);
          answer.push_back(with_tangent[row][place]);
          // The compiler may fuse another multiplication and addition where it also makes the tangent.
          const double difference = std::abs(with_tangent[row][place] - walks[w].stresses[row][place]);
          const double scale = moment + std::abs(with_tangent[row][place]);
          off_with_tangent.see(difference / scale, [&] { return at(subject, s); });
          for (Component column : components) answer.push_back(tangents(row, column)[place]);
        }
        answers.push_back(answer);
      }
      for (const std::vector<double>& answer : answers) {
        INFO(at(subject, s));
        REQUIRE(std::memcmp(answer.data(), answers[0].data(), answer.size() * sizeof(double)) == 0);
      }
    }
  }
  CHECK_MESSAGE(off_with_tangent.value <= 1e-13, "with the tangent the resultants differ by ", off_with_tangent.value,
                " at ", off_with_tangent.where);
}

void check_closed_loop(const Law& law, const LawDescription& what) {
  constexpr std::size_t steps = 24;  // per cycle
  constexpr double parts[] = {0.05, 0.2, 0.5, 1};
  const double moment = stick_stiffness(law, what) * what.curvature;
  for (Component direction : {bending2, bending3}) {
    if (!carries(law.dimension(), direction)) continue;
    Field now(law.dimension(), std::size(parts));
    std::fill_n(now[axial].begin(), std::size(parts), what.strain);
    Walk walk(law, now);
    std::vector<Field> first_loop;
    const std::size_t settled = static_cast<std::size_t>(what.settling) * steps;
    for (std::size_t s = 1; s <= settled + 2 * steps; ++s) {
      const double phase = 2 * std::numbers::pi * static_cast<double>(s) / steps;
      for (std::size_t i = 0; i < std::size(parts); ++i) {
        now[direction][i] = parts[i] * what.curvature * std::sin(phase);
      }
      walk.step(now);
      if (s <= settled) continue;  // the virgin branch, and what wires do to each other
      if (s <= settled + steps) {
        first_loop.push_back(walk.stresses);
        continue;
      }
      const Field& earlier = first_loop[s - settled - steps - 1];
      for (std::size_t i = 0; i < std::size(parts); ++i) {
        check_close(walk.stresses[direction][i], earlier[direction][i], {.absolute = 1e-12 * moment},
                    fmt::format("amplitude {} of the range, step {}:", parts[i], s));
      }
    }
  }
}

void check_rotation(const Law& law, const LawDescription& what) {
  REQUIRE(law.dimension() == Dimension::spatial);
  const PathPlan plan{.points = 40, .steps = 25, .stream = 7};
  const std::vector<Field> path = random_paths(law.dimension(), what, plan);
  const double moment = stick_stiffness(law, what) * what.curvature;
  for (int turns : {1, 2, 5}) {
    const double c = std::cos(turns * what.grid_angle);
    const double s = std::sin(turns * what.grid_angle);
    const auto turned = [&](const Field& field) {
      Field result = field;
      for (std::size_t i = 0; i < field.points(); ++i) {
        result[bending2][i] = c * field[bending2][i] - s * field[bending3][i];
        result[bending3][i] = s * field[bending2][i] + c * field[bending3][i];
      }
      return result;
    };
    Walk walk(law, path[0]);
    Walk other(law, path[0]);
    Worst off;
    for (std::size_t step = 1; step < path.size(); ++step) {
      walk.step(path[step]);
      other.step(turned(path[step]));
      const Field expected = turned(walk.stresses);
      for (std::size_t i = 0; i < plan.points; ++i) {
        const auto here = [&] { return at(i, step); };
        for (Component row : {torsion, bending2, bending3}) {
          off.see(std::abs(other.stresses[row][i] - expected[row][i]) / moment, here);
        }
        off.see(std::abs(other.energy.dissipated[i] - walk.energy.dissipated[i]) / (moment * what.curvature), here);
      }
    }
    CHECK_MESSAGE(off.value <= 1e-10, turns, " grid angles: off by ", off.value, " of the moment at ", off.where);
  }
}

}  // namespace strandyn::test
