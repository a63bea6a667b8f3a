#pragma once
/// \file The ledger and the motion cycle by cycle, and where along the span the energy is lost.

#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "strandyn/observe/deflection_points.hpp"
#include "strandyn/observe/ledger.hpp"
#include "strandyn/observe/swing_range.hpp"

namespace strandyn::observe {

/// One cycle. Energies in J: work and losses of the cycle, kinetic and elastic at its end.
struct Cycle {
  double end_time = 0;            ///< [s]
  double antinode_amplitude = 0;  ///< [m] half of the greatest distance between two positions of one place
  double external_work = 0;
  double wind = 0;  ///< its work
  double kinetic = 0;
  double elastic = 0;  ///< above that of the initial state
  double friction = 0;
  double material = 0;
  double viscous = 0;
  system::ViscousLoss viscous_parts = {};  ///< the same by name
  double air = 0;
  double attached = 0;  ///< by Stockbridge dampers
  double numerical = 0;
  double quadrature_error = 0;
  double internal_work = 0;
  std::size_t elements_slipping = 0;  ///< in which some friction was dissipated

  void archive(Archive& a) {
    a(end_time, antinode_amplitude, external_work, wind, kinetic, elastic, friction, material, viscous);
    for (const system::ViscousTerm& term : system::viscous_terms) a(viscous_parts.*term.value);
    a(air, attached, numerical, quadrature_error, internal_work, elements_slipping);
  }
  /// What counts as self-damping, where viscous damping stands for it; and all that physics takes.
  double self_damping() const { return friction + material + viscous; }
  double dissipated() const { return self_damping() + air + attached; }
  double work_in() const { return external_work + wind; }
};

/// The columns of cycles.csv and the members of `cycles[]`.
template <class V>
void members(V& v, Cycle& c) {
  v.value("t_s", c.end_time, {.what = "the end of the cycle"});
  v.value("antinode_amplitude_m", c.antinode_amplitude,
          {.what = "half of peak to peak at the largest antinode away from the ends, in whatever direction it swings",
           .shown = "antinode amplitude"});
  v.value("external_work_J", c.external_work, {.what = "work of the loads and of moved supports"});
  v.value("wind_work_J", c.wind, {.what = "work of the wind"});
  v.value("kinetic_J", c.kinetic, {.what = "kinetic energy at the end"});
  v.value("elastic_J", c.elastic, {.what = "elastic energy at the end, above that of the initial state"});
  v.value("friction_dissipation_J", c.friction, {.what = "friction between the wires", .shown = "friction per cycle"});
  v.value("material_dissipation_J", c.material, {.what = "damping of the metal of the wires"});
  v.value("viscous_dissipation_J", c.viscous, {.what = "all viscous damping"});
  for (const system::ViscousTerm& term : system::viscous_terms) {
    v.value(term.name, c.viscous_parts.*term.value, {.what = term.what});
  }
  v.value("air_dissipation_J", c.air, {.what = "still air, which is no self-damping"});
  v.value("damper_dissipation_J", c.attached, {.what = "friction and metal of Stockbridge dampers, no self-damping"});
  v.value("numerical_dissipation_J", c.numerical,
          {.what = "what the other terms leave over: the integrator's error", .shown = "numerical part per cycle"});
  v.value("quadrature_error_J", c.quadrature_error,
          {.what = "error of the steps of friction and metal, contained in the numerical part with a minus"});
  v.value("internal_work_J", c.internal_work, {.what = "trapezoidal work of the internal forces"});
  v.value("elements_slipping", c.elements_slipping, {.what = "elements in which some friction was dissipated"});
}

struct CycleOptions {
  double period = 0;       ///< [s]
  double loop_length = 0;  ///< [m] half a wave: antinodes closer than this to a support do not count
  std::size_t kept = 20;   ///< last cycles over which profiles are averaged
  std::size_t most = std::numeric_limits<std::size_t>::max();  ///< last cycles that `cycles` holds
  std::function<void(const Cycle&)> each = {};                 ///< hears of every cycle as it ends
};

/// Along the span, one entry per section point, mean of the last cycles.
struct Profile {
  std::vector<double> position;             ///< [m] along the reference configuration
  std::vector<double> length;               ///< [m] without tension, for which the point stands
  std::vector<double> friction;             ///< [J/m] per cycle
  std::vector<double> material;             ///< [J/m] per cycle, of the metal
  std::vector<double> curvature_amplitude;  ///< [1/m] half of peak to peak, about the axis where it is larger
  std::size_t cycles = 0;                   ///< over how many

  /// [J/m] per cycle that count as self-damping.
  double self_damping(std::size_t point) const { return friction[point] + material[point]; }
};

/// Cuts a run into cycles. An end that falls inside a step is found by linear interpolation of the ledger.
class CycleObserver final : public Observer {
 public:
  explicit CycleObserver(CycleOptions options) : options_(options) {}

  void begin(const system::System& system, const StepRecord& initial) override;
  void step(const system::System& system, const StepRecord& record) override;
  void exchanged(const StepRecord& record) override { ledger_.exchanged(record); }
  bool wants_forces() const override { return true; }
  void archive(Archive& a) override;

  const std::vector<Cycle>& cycles() const { return cycles_; }  ///< the last ones, at least `most` where there are more
  std::size_t count() const { return count_; }                  ///< of all that have ended
  const Ledger& ledger() const { return ledger_; }
  Profile profile(const system::System& system) const;

 private:
  /// Lowest and highest value of each of a row of quantities in the cycle under way.
  struct Range {
    std::vector<double> low, high;
    void restart(std::size_t size);
    void widen(std::size_t i, double value);
    double amplitude(std::size_t i) const { return 0.5 * (high[i] - low[i]); }
    void archive(Archive& a) { a(low, high); }
  };
  struct PointRecord {
    std::vector<double> friction, material, curvature_amplitude;
    void archive(Archive& a) { a(friction, material, curvature_amplitude); }
  };

  void watch(const system::System& system, const StepRecord& record);
  void end_cycle(const Account& at_end, double time);
  void restart(const system::System& system);
  void check_read() const;

  CycleOptions options_;
  Ledger ledger_;
  Account before_;  // at the previous step
  Account cycle_start_;
  double time_before_ = 0;
  std::vector<Cycle> cycles_;
  std::size_t count_ = 0;
  std::optional<DeflectionPoints> places_;
  bool system_is_planar_ = true;
  SwingRange deflection_;
  Range curvature_, curvature_3_;            // curvatures about the axes 2 and 3; about 2 only in a plane
  std::vector<double> friction_, material_;  // [J/m] of each section point in the cycle under way
  std::deque<PointRecord> kept_;
};

}  // namespace strandyn::observe
