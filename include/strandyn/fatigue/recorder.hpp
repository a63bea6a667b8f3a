#pragma once
/// \file What a vibration recorder on a clamp counts: cycles by bending amplitude and frequency.
///
/// A cycle goes from one upward pass through the deflection at rest to the next; its amplitude is peak to peak, its
/// frequency one over its time. Passes are found by straight lines between samples. Bins are 20 micrometres and 1 Hz
/// wide and told by their middles; what swings less than half a bin of amplitude does not count, as no recorder sees
/// it.

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace strandyn::fatigue {

struct RecordedCycles {
  double bending_amplitude = 0;  ///< [m] peak to peak, the middle of its bin
  double frequency = 0;          ///< [Hz] likewise
  double cycles = 0;
};

class Recorder {
 public:
  /// A sample of the deflection [m] at a time [s]; the first one is that at rest.
  void add(double time, double deflection);
  /// All bins in which there is a cycle, by amplitude and frequency.
  std::vector<RecordedCycles> matrix() const;

  template <class Archive>
  void archive(Archive& a) {
    std::vector<double> counts;
    for (const auto& [bin, cycles] : counts_) {
      counts.insert(counts.end(), {static_cast<double>(bin.first), static_cast<double>(bin.second), cycles});
    }
    std::size_t size = counts.size();
    a(size);
    counts.resize(size);
    for (double& x : counts) a(x);
    counts_.clear();
    for (std::size_t i = 0; i + 2 < size; i += 3) {
      counts_[{static_cast<long>(counts[i]), static_cast<long>(counts[i + 1])}] = counts[i + 2];
    }
    a(rest_, pass_, time_, last_, low_, high_);
  }

 private:
  std::map<std::pair<long, long>, double> counts_;  // by bin of amplitude and of frequency
  std::optional<double> rest_;                      // [m]
  std::optional<double> pass_;                      // [s] the last upward one
  double time_ = 0, last_ = 0;                      // of the last sample, from rest
  double low_ = 0, high_ = 0;                       // [m] since that pass
};

}  // namespace strandyn::fatigue
