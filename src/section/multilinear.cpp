#include "strandyn/section/multilinear.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "multilinear_kernel.hpp"

namespace strandyn::section {

using enum Component;

namespace {

/// How the bending axes of a law meet: one axis, two with springs of their own, two that share them.
enum class Axes { one, two, shared };

Axes axes_of(const MultilinearSection& section, Dimension dimension) {
  if (dimension == Dimension::planar) return Axes::one;
  return section.coupling == BendingCoupling::coupled ? Axes::shared : Axes::two;
}

std::size_t axis_size(const MultilinearSection& section, std::size_t points) {
  return padded(points) * multilinear_kernel::axis_rows(section);
}

multilinear_kernel::Curvatures curvatures(const Field& strains) {
  return {.points = strains.points(), .chi2 = strains[bending2].data(), .chi3 = strains[bending3].data()};
}

}  // namespace

std::optional<std::string> find_fault(const MultilinearSection& section) {
  const auto bad = [](double x) { return !std::isfinite(x) || x < 0; };
  if (!(section.EA > 0) || !std::isfinite(section.EA)) return fmt::format("EA = {} N: must be positive", section.EA);
  if (bad(section.GJ)) return fmt::format("GJ = {} N m^2: must not be negative", section.GJ);
  if (bad(section.EI)) return fmt::format("EI = {} N m^2: must not be negative", section.EI);
  for (std::size_t i = 0; i < section.springs.size(); ++i) {
    const Spring& s = section.springs[i];
    if (bad(s.stiffness)) return fmt::format("spring {}: stiffness {} N m^2 must not be negative", i + 1, s.stiffness);
    if (!(s.yield > 0) || !std::isfinite(s.yield)) {
      return fmt::format("spring {}: yield curvature {} 1/m must be positive", i + 1, s.yield);
    }
  }
  return std::nullopt;
}

History MultilinearLaw::start(const Field& strains) const {
  const std::size_t axes = dimension_ == Dimension::planar ? 1 : 2;
  History history{.points = strains.points(), .data = {}};
  history.data.assign(axes * axis_size(section_, strains.points()), 0.0);
  StepEnergy ignored(strains.points());  // the way to the start is not a step
  commit(history, strains, ignored);
  return history;
}

Effort MultilinearLaw::respond(const History& history, const Field& strains, Field& stresses,
                               TangentField* tangents) const {
  const std::size_t points = strains.points();
  const auto fill = [tangents](Component c, double value) {
    AlignedVector& entries = (*tangents)(c, c);
    std::fill(entries.begin(), entries.end(), value);
  };
  const auto times = [&](Component c, double stiffness) {
    for (std::size_t i = 0; i < strains[c].size(); ++i) stresses[c][i] = stiffness * strains[c][i];
    if (tangents) fill(c, stiffness);
  };
  const auto axis = [&](Component c, const double* rows) {
    multilinear_kernel::respond_axis(
        section_, rows, points, strains[c].data(),
        {.M = stresses[c].data(), .dM_dchi = tangents ? (*tangents)(c, c).data() : nullptr});
  };

  times(axial, section_.EA);
  if (dimension_ == Dimension::spatial) times(torsion, section_.GJ);
  const Axes axes = axes_of(section_, dimension_);
  if (axes == Axes::shared) {
    multilinear_kernel::PairResponse out{.M2 = stresses[bending2].data(), .M3 = stresses[bending3].data()};
    if (tangents) {
      out.dM2_dchi2 = (*tangents)(bending2, bending2).data();
      out.dM2_dchi3 = (*tangents)(bending2, bending3).data();
      out.dM3_dchi3 = (*tangents)(bending3, bending3).data();
    }
    multilinear_kernel::respond_pair(section_, history.data.data(), curvatures(strains), out);
    if (tangents) (*tangents)(bending3, bending2) = (*tangents)(bending2, bending3);
  } else {
    axis(bending2, history.data.data());
    if (axes == Axes::two) axis(bending3, history.data.data() + axis_size(section_, points));
  }
  return {.evaluations = points, .sweeps = points};
}

Effort MultilinearLaw::commit(History& history, const Field& strains, StepEnergy& energy) const {
  const std::size_t points = strains.points();
  std::fill(energy.stored.begin(), energy.stored.end(), 0.0);
  std::fill(energy.dissipated.begin(), energy.dissipated.end(), 0.0);
  std::fill(energy.quadrature_error.begin(), energy.quadrature_error.end(), 0.0);
  const auto store_linear = [&](Component c, double stiffness) {
    for (std::size_t i = 0; i < strains[c].size(); ++i) {
      energy.stored[i] += 0.5 * stiffness * strains[c][i] * strains[c][i];
    }
  };
  const auto axis = [&](Component c, double* rows) {
    multilinear_kernel::commit_axis(section_, rows, points, strains[c].data(), energy);
  };

  store_linear(axial, section_.EA);
  store_linear(bending2, section_.EI);
  if (dimension_ == Dimension::spatial) {
    store_linear(torsion, section_.GJ);
    store_linear(bending3, section_.EI);
  }
  const Axes axes = axes_of(section_, dimension_);
  if (axes == Axes::shared) {
    multilinear_kernel::commit_pair(section_, history.data.data(), curvatures(strains), energy);
  } else {
    axis(bending2, history.data.data());
    if (axes == Axes::two) axis(bending3, history.data.data() + axis_size(section_, points));
  }
  return {.evaluations = points, .sweeps = points};
}

}  // namespace strandyn::section
