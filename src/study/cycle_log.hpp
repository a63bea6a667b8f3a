#pragma once
/// \file The cycles of a run as its results have them: all of them in cycles.csv, written as they end; in the summary
/// the first and the last thousand, and of all the least, the largest and the sum.

#include <deque>
#include <fstream>
#include <functional>

#include "strandyn/observe/cycles.hpp"
#include "strandyn/results/reference.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

/// A cycle and its number, from 1.
struct NumberedCycle {
  std::size_t number = 0;
  observe::Cycle cycle;
};

class CycleLog final : public observe::Observer {
 public:
  /// Of a cycle, where the summary is to have it.
  using DampingRatio = std::function<double(const observe::Cycle&)>;

  /// Writes into the folder; an empty one: nowhere.
  explicit CycleLog(const std::filesystem::path& folder, DampingRatio damping_ratio = {});

  void add(const observe::Cycle& cycle);

  void begin(const system::System&, const observe::StepRecord&) override {}
  void step(const system::System&, const observe::StepRecord&) override {}
  /// A log that reads goes on with the cycles up to the checkpoint: what the file has beyond them is cut.
  void archive(Archive& a) override;

  std::size_t count() const { return count_; }
  std::vector<NumberedCycle> rows() const;  ///< the first and the last thousand
  /// `cycles` and `cycle_count` of the summary, cycles.csv.
  void add_to(Outcome& outcome) const;
  static std::vector<results::MemberNote> notes();

 private:
  void reopen();

  std::filesystem::path path_;
  DampingRatio damping_ratio_;
  std::ofstream file_;
  std::size_t count_ = 0;
  std::optional<std::size_t> recomputed_;  // cycles that the file had beyond the checkpoint, where there was one
  std::vector<observe::Cycle> first_;
  std::deque<observe::Cycle> last_;
  std::vector<double> least_, largest_, sum_;  // of each member
};

}  // namespace strandyn::study
