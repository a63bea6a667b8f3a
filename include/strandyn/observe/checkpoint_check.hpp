#pragma once
/// \file Whether the state that a run takes up is one that a run can have left, though its checksum fits.
///
///     time      0 <= t <= end, and the next step begins there
///     strains   those of u are the committed ones
///     energies  kinetic, of (u, v); stored, which the law finds again when it commits the strains to the history that
///               they are committed in: both as they were written, and as the ledger has them
///     losses    friction, metal and air have taken, not given
/// What a sum over all steps holds beyond that (the work, the losses themselves) nothing in the state can confirm.

#include "strandyn/observe/ledger.hpp"

namespace strandyn::observe {

/// Stands last among the observers of a run: it looks at what all others have read. A state that does not hold is
/// refused with an InputError.
class CheckpointCheck final : public Observer {
 public:
  /// The ledger must outlive it; `end_time` [s] is that of the run.
  CheckpointCheck(const Ledger& ledger, double end_time) : ledger_(ledger), end_time_(end_time) {}

  void begin(const system::System& system, const StepRecord& initial) override;
  void step(const system::System& system, const StepRecord& record) override;
  bool wants_forces() const override { return true; }  // as the ledger does
  void archive(Archive& a) override;

  /// Whether a state has been read and not yet been gone on from: what is thrown then is a fault of the state.
  bool takes_up() const { return takes_up_; }
  /// To be called where a state will be read.
  void expect_state() { takes_up_ = true; }
  /// To be called with the time [s] that a run says it has reached: one that had nothing left to do has it in its
  /// state.
  void ended(double time);

 private:
  struct Stored {
    double elastic = 0;      // [J] above that of the begin
    double of_sections = 0;  // [J] in all: the scale of its rounding
  };
  void check_numbers() const;
  void check_state(double kinetic_written, double elastic_written) const;
  double kinetic() const;
  Stored stored_by_law() const;

  const Ledger& ledger_;
  double end_time_;
  const system::System* system_ = nullptr;
  const system::Vector* u_ = nullptr;  // of the run, as long as it lasts
  const system::Vector* v_ = nullptr;
  double initial_elastic_ = 0;  // [J]
  double time_ = 0;             // [s] of the last step
  double elastic_ = 0;          // [J] at its end
  bool takes_up_ = false;
};

}  // namespace strandyn::observe
