#pragma once
/// \file [output]: fields.vtkhdf, the moving span for ParaView and for whoever reads HDF5.
///
///     at points   displacement [m] from the state without load, velocity [m/s]
///     in cells    tension [N], moment [N m], curvature [1/m] (means of an element's two section points; in space the
///                 sizes of both bendings together), slip_fraction [-] of the wires around the lay, where the law knows
///                 wires, dissipated_J_per_m since the start: friction and the metal

#include <memory>

#include "strandyn/observe/step_record.hpp"
#include "strandyn/results/reference.hpp"
#include "strandyn/results/vtkhdf.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

class FieldWriter final : public observe::Observer {
 public:
  /// `frequency` [Hz] of the run's cycle; 0 where it has none. Nothing is written where `hooks` names no folder.
  FieldWriter(const casefile::Scene& scene, const Hooks& hooks, double frequency);

  void begin(const system::System& system, const observe::StepRecord& initial) override;
  void step(const system::System& system, const observe::StepRecord& record) override;
  void archive(Archive& a) override;
  /// Everything on disk; the file is told to `outcome`.
  void end(Outcome& outcome);
  static std::vector<results::MemberNote> notes();

 private:
  results::Moment moment_of(const system::System& system, const observe::StepRecord& record) const;
  void put(const results::Moment& moment);

  bool has_wires_;
  std::filesystem::path path_;
  double every_ = 0;                // [s]
  std::size_t due_ = 0, kept_ = 0;  // moments that were due, that are in the file
  std::vector<std::array<double, 3>> nodes_;
  std::vector<double> dissipated_;  // [J/m] per section point
  std::optional<results::Moment> initial_;
  std::unique_ptr<results::VtkHdfFile> file_;
};

/// Refuses [output] in an analysis that does not integrate, in a run without a cycle that it would count, and where the
/// program has no HDF5.
void check_output(const casefile::Scene& scene);

}  // namespace strandyn::study
