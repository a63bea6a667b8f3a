#pragma once
/// \file checkpoint.bin in the results folder: the state of a run under way, and the case that it belongs to.

#include <chrono>
#include <functional>

#include "strandyn/casefile/scene.hpp"
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

 private:
  bool is_due() const;
  void write(const std::string& state);

  std::filesystem::path path_;
  std::optional<double> every_;  // [s] of wall time
  std::string identity_;         // of the case
  std::string resume_;
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
};

}  // namespace strandyn::study
