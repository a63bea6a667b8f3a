#pragma once
/// \file What the dissipation of a vibration is off by, as a part of it: by differences between runs of a few cycles.
///
/// With D(N, s, p) the dissipation on N elements in s steps a cycle with p points a turn; N_0, s_0, p_0 what the search
/// begins with; r = s_0/4 where that is 10 steps a cycle and more, s_0/2 where it is less or near a resonance; m the
/// ratio of meshes:
///     time:    |D(N_0/2, s) - D(N_0/2, s')|/((s/s')^2 - 1)   s' the steps of the search before s; s_0/2 before s_0
///     mesh:    |D(N, r) - D(N/m, r)|/(m^q - 1)                q by the same difference one mesh further down
///     points:  |D(N/m^2, r, p) - D(N/m^2, r, p')|             p' the next finer
/// Each part is estimated by its own knob, the others as they were begun with: nothing is run as fine as the run itself
/// but in one of the two, and what one part asks for runs no other anew. m is the root of two: halves of a mesh may be
/// too coarse for the mode, and the estimate is then ten times too large; where the target is so wide that the meshes
/// are coarse themselves, their loss is no smooth function, and halves see more of that. Of a decay |.| is that of the
/// sum of its cycles or, where errors of both signs cancel in it, the root of the sum of squares. The parts are added
/// up.

#include <cmath>
#include <compare>
#include <functional>
#include <map>
#include <optional>
#include <set>

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
  /// `scene` asks for no accuracy; `first` is what is begun with. The first cycles of a decay, the whole of a forced
  /// vibration; what `run` does, if it is given: a steady vibration at resonance.
  Stretch(const casefile::Scene& scene, const Setting& first, double mesh_ratio, const Hooks& hooks, LossRun run = {});

  /// Empty where a run was stopped; failed ones leave a part that is infinite.
  std::optional<ErrorEstimate> estimate(const Setting& setting);
  /// [-] what the first estimate takes of the run that it is of.
  double share_of_first() const;
  const Cost& cost() const { return cost_; }

 private:
  const Lost& run(const Setting& setting);
  double by_time(const Setting& setting);
  bool has_many_steps() const { return first_.steps_per_cycle >= 40; }
  /// A step by which a mesh is judged: so many times as long. Near a resonance four times detunes too much.
  int times_slower() const { return has_many_steps() && !resonates_ ? 4 : 2; }
  static double apart(const Lost& a, const Lost& b);

  casefile::Scene scene_;
  Setting first_;
  double mesh_ratio_;
  std::set<int> steps_;  ///< of the search so far, and coarser
  const Hooks& hooks_;
  LossRun run_;
  bool slips_, resonates_;
  double share_of_cycles_ = 1;
  std::map<Setting, Lost> results_;
  Cost cost_;
};

}  // namespace strandyn::study
