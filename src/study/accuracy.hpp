#pragma once
/// \file What the dissipation of a vibration is off by, as a part of it: by differences between runs of a few cycles.
///
/// With D(N, s, p) the dissipation on N elements in s steps a cycle with p points a turn, r = s/4 where that is still
/// 20 steps a cycle, else s/2,
///     time:    |D(N/2, s) - D(N/2, s/2)|/3               errors of order 2
///     mesh:    |D(N, r) - D(N/2, r)|/(2^q - 1)           q by the same difference one mesh further down
///     points:  |D(N/2, r, p) - D(N/2, r, p')|            p' the next finer
/// so that nothing is run as fine as the run itself but in one of the two. Of a decay |.| is that of the sum of its
/// cycles or, where errors of both signs cancel in it, the root of the sum of squares. The parts are added up.

#include <cmath>
#include <compare>
#include <functional>
#include <map>
#include <optional>

#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

/// What the error of a vibration hangs on.
struct Setting {
  int elements = 0, steps_per_cycle = 0, points = 0;
  auto operator<=>(const Setting&) const = default;
};

/// The scene with that mesh, step and number of points.
casefile::Scene with_setting(casefile::Scene scene, const Setting& setting);

/// `error_estimate` of summary.json, relative to the dissipation, or to 1e-4 of the energy where that is more.
struct ErrorEstimate {
  double target = 0, mesh = 0, time = 0;
  std::optional<double> points{};
  double section_evaluations = 0;

  double relative() const { return mesh + time + points.value_or(0); }
};
template <class V>
void members(V& v, ErrorEstimate& e) {
  // Infinite where a coarser run has failed: no number.
  const auto known = [](double x) { return std::isfinite(x) ? std::optional(x) : std::nullopt; };
  v.value(
      "relative", known(e.relative()),
      {.what = "of the dissipation: the sum of its parts; a part that could not be estimated is absent, and so is this",
       .shown = "estimated error"});
  v.value("target", e.target, {.what = "that the case asks for"});
  v.value("mesh", known(e.mesh), {.what = "by the elements"});
  v.value("time", known(e.time), {.what = "by the steps"});
  v.value("points", known(e.points.value_or(INFINITY)),
          {.what = "by the points of a section; absent where no wires slip"});
  v.value("section_evaluations", e.section_evaluations, {.what = "that the estimate took, among those of `cost`"});
}

/// What one setting gives.
struct Lost {
  bool interrupted = false;
  std::vector<double> dissipation{};  ///< [J] of each cycle, or of a steady one; empty where the run failed
  double energy = 0;                  ///< [J] the largest that moves
};
/// Runs a scene that a setting was put into, for what is no decay and no forced vibration; adds its work to the cost. A
/// ComputationError or InputError thrown is a run that failed.
using LossRun = std::function<Lost(const casefile::Scene& scene, const Hooks& hooks, Cost& cost)>;

/// A stretch of a vibration, run with one setting after another.
class Stretch {
 public:
  /// `scene` asks for no accuracy. The first cycles of a decay, the whole of a forced vibration; what `run` does, if it
  /// is given: a steady vibration at resonance.
  Stretch(const casefile::Scene& scene, const Hooks& hooks, LossRun run = {});

  /// Empty where a run was stopped; failed ones leave a part that is infinite.
  std::optional<ErrorEstimate> estimate(const Setting& setting);
  const Cost& cost() const { return cost_; }

 private:
  const Lost& run(const Setting& setting);
  static double apart(const Lost& a, const Lost& b);

  casefile::Scene scene_;
  const Hooks& hooks_;
  LossRun run_;
  bool slips_, resonates_;
  std::map<Setting, Lost> results_;
  Cost cost_;
};

}  // namespace strandyn::study
