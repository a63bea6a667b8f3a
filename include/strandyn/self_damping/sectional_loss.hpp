#pragma once
/// \file What a section loses in one cycle of curvature, as a function of the amplitude chi at one tension.
///
///     D(chi) [J/m] = 2 (loss of the way from +chi to -chi),   after a first way from -chi to +chi
/// computed by the section law itself. Laws do not depend on rate, and bending to one side is like bending to the
/// other: half a cycle is enough, and after one half the limits that follow the wire forces have settled. The loss is
/// the trapezoidal work (dissipation less the error of the steps): 64 steps take 5e-4 too little, 32 take 2e-3.
///
/// The secant stiffness M(chi)/chi at the peak of the closed loop comes with it: it sets the length of the wave.
///
/// D rises from an onset chi_on (the first slip of rigid contacts; zero where contacts give) and is tabulated in
///     v = ln D,   u = ln(chi - chi_on)
/// in which it is nearly straight from the onset (D linear in chi - chi_on) to full slip (D ~ chi): monotone cubics
/// between the knots, straight lines beyond them. The knots of a pass go through the law side by side. Each pass halves
/// the intervals in whose middle the cubic was off by more than `tolerance`: they gather where a layer begins to slip.

#include <cstdint>
#include <span>
#include <vector>

#include "strandyn/core/stop.hpp"
#include "strandyn/results/record.hpp"
#include "strandyn/section/law.hpp"
#include "strandyn/self_damping/point_error.hpp"

namespace strandyn::self_damping {

struct CurvatureRange {
  double lowest = 0;   ///< [1/m] above zero
  double highest = 0;  ///< [1/m]
};

/// At what a section is looked at.
struct SectionState {
  double axial_strain = 0;  ///< [-] of the tension
  double EI_max = 0;        ///< [N m^2] a loss below 1e-12 EI_max chi^2 is rounding
};

struct LossOptions {
  int steps = 64;             ///< of half a cycle
  int knots_per_decade = 24;  ///< of chi - chi_on, in the first pass; 8 miss ripples of 0.3 % that springs leave
  double tolerance = 1e-3;    ///< [-] of D in the middle between two knots
  int passes = 6;             ///< at most
  Stop stop = {};             ///< asked between loops, from any thread: Interrupted is thrown
};

/// A closed loop.
struct ClosedLoop {
  double loss = 0;    ///< [J/m] per cycle
  double moment = 0;  ///< [N m] at its peak
};
/// Of each amplitude, without a table.
std::vector<ClosedLoop> closed_loops(const section::Law& law, const SectionState& state,
                                     std::span<const double> amplitudes, const LossOptions& options,
                                     section::Effort& effort);
/// [J/m] the loss alone.
std::vector<double> loss_per_cycle(const section::Law& law, const SectionState& state,
                                   std::span<const double> amplitudes, const LossOptions& options,
                                   section::Effort& effort);

/// A table as a file keeps it: what it was made for, and its knots in the order of their amplitudes.
struct LossTable {
  double tension = 0;              ///< [N]
  double lowest = 0, highest = 0;  ///< [1/m] CurvatureRange
  double onset = 0;                ///< [1/m]
  double sticking = 0;             ///< [N m^2]
  std::vector<double> places{};    ///< [-] ln(chi - chi_on), chi in 1/m
  std::vector<double> losses{};    ///< [J/m]
  std::vector<double> secants{};   ///< [N m^2]
  std::uint64_t evaluations = 0, sweeps = 0;
  std::optional<PointError> error{};  ///< where an accuracy was asked for, like the next
  std::optional<PointChoice> chosen{};

  /// Of the same length, finite, in rising order: whatever wrote it.
  bool is_sound() const;
};
template <class V>
void members(V& v, LossTable& t) {
  v.value("tension_N", t.tension, {.what = "at which the section was bent"});
  v.value("lowest_per_m", t.lowest, {.what = "the curvatures that the points ask for: from here"});
  v.value("highest_per_m", t.highest, {.what = "to here"});
  v.value("onset_per_m", t.onset, {.what = "the curvature up to which nothing is lost"});
  v.value("sticking_N_m2", t.sticking, {.what = "secant stiffness up to there"});
  v.value("places", t.places, {.what = "of the knots: logarithms of the curvature beyond the onset"});
  v.value("losses_J_per_m", t.losses, {.what = "at the knots, per cycle"});
  v.value("secants_N_m2", t.secants, {.what = "at the knots"});
  v.value("section_evaluations", t.evaluations, {.what = "what the table took"});
  v.value("section_sweeps", t.sweeps, {.what = "of these, the ones that marched through the layers"});
  v.record("error_estimate", t.error, {.what = "where the case asks for an accuracy"});
  v.record("chosen", t.chosen, {.what = "for that accuracy, by key"});
}

class SectionalLoss {
 public:
  /// For amplitudes up to `range.highest`; below `range.lowest` the power law of the first knots goes on.
  SectionalLoss(const section::Law& law, const SectionState& state, const CurvatureRange& range,
                const LossOptions& options = {});
  /// The same to the bit from what `table` gave; it must be sound.
  explicit SectionalLoss(const LossTable& table);
  /// What a file keeps of it; tension and range are the caller's.
  LossTable table() const;

  double at(double amplitude) const;  ///< [J/m]
  /// [N m^2] at the peak of the loop; below all knots that of the lowest one, or of sticking wires.
  double secant(double amplitude) const;
  double onset() const { return onset_; }                                ///< [1/m] nothing is lost up to here
  bool loses() const { return !losses_.empty(); }                        ///< anywhere in the range
  const std::vector<double>& amplitudes() const { return amplitudes_; }  ///< [1/m] of the knots
  const std::vector<double>& losses() const { return losses_; }          ///< [J/m] at them
  const section::Effort& effort() const { return effort_; }

 private:
  void fill(const section::Law& law, const SectionState& state, const LossOptions& options);
  void add_knots(const section::Law& law, const SectionState& state, std::vector<double> places,
                 const LossOptions& options);
  void insert(double place, double loss, double secant);
  double value_at(double place) const;  ///< v of u

  double onset_ = 0;
  double sticking_ = 0;  ///< [N m^2] secant up to the onset
  std::vector<double> amplitudes_, losses_, secants_;
  std::vector<double> place_, value_, slope_;  ///< u, v and dv/du of the knots
  section::Effort effort_;
};

}  // namespace strandyn::self_damping
