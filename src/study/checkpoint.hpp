#pragma once
/// \file checkpoint.bin in the results folder: the state of a run under way, and the case that it belongs to.

#include <chrono>
#include <functional>

#include "strandyn/casefile/scene.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/observe/checkpoint_check.hpp"
#include "strandyn/solver/time/integrator.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

/// Reads the file where the run is to go on from it. Throws FileError where it cannot be read, InputError where it was
/// written by another case.
class CheckpointFile {
 public:
  CheckpointFile(const casefile::Scene& scene, const Hooks& hooks);
  CheckpointFile(const CheckpointFile&) = delete;
  CheckpointFile& operator=(const CheckpointFile&) = delete;

  /// For the integrator. Where the case asks for checkpoints, one is due every so often, and when the run is
  /// interrupted. This object must outlive the run.
  solver::Checkpoints checkpoints(std::function<bool()> interrupted);

  /// Runs what takes up the state. What is thrown as long as the check waits for it is a fault of the file: an
  /// InputError that names it.
  template <class Run>
  solver::IntegratorSummary take_up(observe::CheckpointCheck& check, Run&& run) {
    if (resumes_) check.expect_state();
    try {
      const solver::IntegratorSummary summary = run();
      check.ended(summary.end_time);
      return summary;
    } catch (const FileError& error) {
      refuse_state(check, error.what());
      throw;
    } catch (const InputError& error) {
      refuse_state(check, error.what());
      throw;
    }
  }

 private:
  bool is_due() const;
  void write(const std::string& state);
  void refuse_state(const observe::CheckpointCheck& check, const std::string& why) const;

  std::filesystem::path path_;
  std::optional<double> every_;  // [s] of wall time
  std::string identity_;         // of the case
  std::string resume_;
  bool resumes_ = false;
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
};

}  // namespace strandyn::study
