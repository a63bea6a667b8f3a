#include "point.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>

#include "strands.hpp"

namespace strandyn::extremes {

using section::Component;
using section::Dimension;

Point::Point(const section::Law& law, Strain start)
    : law_(law),
      strains_(law.dimension(), 1),
      stresses_(law.dimension(), 1),
      tangents_(law.dimension(), 1),
      energy_(1) {
  put(start);
  history_ = law.start(strains_);
}

void Point::put(Strain to) {
  strains_[Component::axial][0] = to.eps;
  strains_[Component::bending2][0] = to.chi2;
  if (law_.dimension() == Dimension::planar) return;
  strains_[Component::torsion][0] = to.chi1;
  strains_[Component::bending3][0] = to.chi3;
}

Answer Point::respond(Strain to) {
  put(to);
  law_.respond(history_, strains_, stresses_, &tangents_);
  Answer a{.N = stresses_[Component::axial][0],
           .M2 = stresses_[Component::bending2][0],
           .EI = tangents_(Component::bending2, Component::bending2)[0]};
  if (law_.dimension() == Dimension::spatial) {
    a.M1 = stresses_[Component::torsion][0];
    a.M3 = stresses_[Component::bending3][0];
  }
  return a;
}

Answer Point::commit(Strain to) {
  Answer a = respond(to);
  law_.commit(history_, strains_, energy_);
  a.stored = energy_.stored[0];
  a.dissipated = energy_.dissipated[0];
  a.quadrature_error = energy_.quadrature_error[0];
  return a;
}

Walk walk(const section::Law& law, const Path& path) {
  constexpr double in_the_last_place = 32 * std::numeric_limits<double>::epsilon();
  Walk w;
  Point point(law, path.front());
  Answer before = point.commit(path.front());
  double remembered = before.stored;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Strain &from = path[i - 1], &to = path[i];
    const Answer a = point.commit(to);
    const double parts[] = {(before.N + a.N) / 2 * (to.eps - from.eps), (before.M1 + a.M1) / 2 * (to.chi1 - from.chi1),
                            (before.M2 + a.M2) / 2 * (to.chi2 - from.chi2),
                            (before.M3 + a.M3) / 2 * (to.chi3 - from.chi3)};
    double work = 0, moved = 0;
    for (double part : parts) {
      work += part;
      moved += std::abs(part);
    }
    const double change = a.stored - before.stored;
    moved += std::abs(change) + a.dissipated + a.quadrature_error;
    const double off = std::abs(change + a.dissipated - a.quadrature_error - work);
    remembered = std::max(remembered, a.stored);
    const double beyond = std::max(0.0, off - in_the_last_place * remembered);
    if (!(beyond <= 0)) w.imbalance = std::max(w.imbalance, beyond / moved);
    if (!std::isfinite(off)) w.imbalance = off;
    w.lost += a.dissipated;
    w.work += work;
    w.quadrature_error += a.quadrature_error;
    w.least_loss = std::min(w.least_loss, a.dissipated);
    w.least_error = std::min(w.least_error, a.quadrature_error);
    before = a;
  }
  w.end = before;
  return w;
}

Path cycles(double eps, double amplitude, int steps, int count) {
  Path path = {{.eps = eps}};
  for (int i = 1; i <= steps * count; ++i) {
    path.push_back({.eps = eps, .chi2 = amplitude * std::sin(2 * std::numbers::pi * i / steps)});
  }
  return path;
}

namespace {

/// Long enough for the clock, short enough for seventy rows.
double seconds_per_step(const section::Law& law, const Path& path) {
  constexpr double long_enough = 4e-3;
  const std::clock_t start = std::clock();
  double seconds = 0;
  std::size_t steps = 0;
  while (seconds < long_enough) {
    Point point(law, path.front());
    for (std::size_t i = 1; i < std::min<std::size_t>(path.size(), 1001); ++i, ++steps) point.commit(path[i]);
    seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  }
  return seconds / static_cast<double>(steps);
}

}  // namespace

Cost cost_of(const section::Law& law, const Path& path, const section::Law& ordinary_law) {
  return {.extreme = seconds_per_step(law, path),
          .ordinary = seconds_per_step(ordinary_law, cycles(strain_at(0.15), 0.03, 100)),
          .unit = "CPU seconds of a step"};
}

void add_account(const Walk& w, Found& found) {
  found.most("balance of energy off by", w.imbalance, 1e-12)
      .least("least loss of a step (J/m)", w.least_loss, 0)
      .least("least quadrature error of a step (J/m)", w.least_error, 0);
}

}  // namespace strandyn::extremes
