#include "strandyn/fatigue/recorder.hpp"

#include <algorithm>
#include <cmath>

namespace strandyn::fatigue {
namespace {

constexpr double amplitude_bin = 20e-6;  // [m]
constexpr double frequency_bin = 1;      // [Hz]

}  // namespace

void Recorder::add(double time, double deflection) {
  if (!rest_) {
    rest_ = deflection;
    time_ = time;
    return;
  }
  const double now = deflection - *rest_;
  low_ = std::min(low_, now);
  high_ = std::max(high_, now);
  if (last_ <= 0 && now > 0) {
    const double passes = time_ + (time - time_) * last_ / (last_ - now);
    if (pass_ && passes > *pass_) {
      const auto amplitude = static_cast<long>(std::floor((high_ - low_) / amplitude_bin + 0.5));
      const auto frequency = static_cast<long>(std::floor(1 / (passes - *pass_) / frequency_bin));
      if (amplitude > 0) counts_[{amplitude, frequency}] += 1;
    }
    pass_ = passes;
    low_ = 0;
    high_ = now;
  }
  time_ = time;
  last_ = now;
}

std::vector<RecordedCycles> Recorder::matrix() const {
  std::vector<RecordedCycles> rows;
  for (const auto& [bin, cycles] : counts_) {
    rows.push_back({.bending_amplitude = static_cast<double>(bin.first) * amplitude_bin,
                    .frequency = (static_cast<double>(bin.second) + 0.5) * frequency_bin,
                    .cycles = cycles});
  }
  return rows;
}

}  // namespace strandyn::fatigue
