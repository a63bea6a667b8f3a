#pragma once
/// \file The ledger and the motion cycle by cycle, and where along the span the energy is lost.

#include <deque>
#include <optional>
#include <vector>

#include "strandyn/observe/deflection_points.hpp"
#include "strandyn/observe/ledger.hpp"

namespace strandyn::observe {

/// One cycle. Energies in J: work and losses of the cycle, kinetic and elastic at its end.
struct Cycle {
  double end_time = 0;            ///< [s]
  double antinode_amplitude = 0;  ///< [m] half of peak to peak at the largest antinode away from the ends
  double external_work = 0;
  double kinetic = 0;
  double elastic = 0;  ///< above that of the initial state
  double friction = 0;
  double viscous = 0;
  system::ViscousLoss viscous_parts = {};  ///< the same by name
  double numerical = 0;
  double quadrature_error = 0;
  double internal_work = 0;
  std::size_t elements_slipping = 0;  ///< in which some friction was dissipated
};

struct CycleOptions {
  double period = 0;       ///< [s]
  double loop_length = 0;  ///< [m] half a wave: antinodes closer than this to a support do not count
  std::size_t kept = 20;   ///< last cycles over which profiles are averaged
};

/// Along the span, one entry per section point, mean of the last cycles.
struct Profile {
  std::vector<double> position;             ///< [m] along the reference configuration
  std::vector<double> friction;             ///< [J/m] per cycle
  std::vector<double> curvature_amplitude;  ///< [1/m] half of peak to peak, about the axis where it is larger
  std::size_t cycles = 0;                   ///< over how many
};

/// Cuts a run into cycles. An end that falls inside a step is found by linear interpolation of the ledger.
class CycleObserver final : public Observer {
 public:
  explicit CycleObserver(CycleOptions options) : options_(options) {}

  void begin(const system::System& system, const StepRecord& initial) override;
  void step(const system::System& system, const StepRecord& record) override;
  bool wants_forces() const override { return true; }
  void archive(Archive& a) override;

  const std::vector<Cycle>& cycles() const { return cycles_; }
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
    std::vector<double> friction, curvature_amplitude;
    void archive(Archive& a) { a(friction, curvature_amplitude); }
  };

  void watch(const system::System& system, const StepRecord& record);
  void end_cycle(const Account& at_end, double time);
  void restart(const system::System& system);

  CycleOptions options_;
  Ledger ledger_;
  Account before_;  // at the previous step
  Account cycle_start_;
  double time_before_ = 0;
  std::vector<Cycle> cycles_;
  std::optional<DeflectionPoints> places_;
  bool system_is_planar_ = true;
  Range deflection_, curvature_, curvature_3_;  // curvatures about the axes 2 and 3; about 2 only in a plane
  std::vector<double> friction_;                // [J/m] of each section point in the cycle under way
  std::deque<PointRecord> kept_;
};

}  // namespace strandyn::observe
