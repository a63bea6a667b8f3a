#pragma once
/// \file What a section without tension answers to a sine of curvature: its complex bending stiffness by amplitude.
///
///     chi = c cos(wt):   M_1 = EI*(c) c exp(i w t),   EI* = secant + i loss,   D = pi c^2 loss per cycle and length
/// The describing function: first harmonic of the closed loop. Found once for all amplitudes side by side, interpolated
/// linearly in ln c; constant below the smallest, above the largest as there.

#include <complex>
#include <vector>

#include "strandyn/section/law.hpp"

namespace strandyn::damper {

struct BendingLoopOptions {
  double smallest = 1e-5;  ///< [1/m] amplitude
  double largest = 30;     ///< [1/m]
  int per_decade = 24;
  int samples = 128;  ///< per cycle
  int cycles = 3;     ///< the last one counts
};

class BendingLoops {
 public:
  BendingLoops(const section::Law& law, const BendingLoopOptions& options = {});

  std::complex<double> stiffness(double amplitude) const;  ///< [N m^2]
  section::Effort effort() const { return effort_; }

 private:
  BendingLoopOptions options_;
  std::vector<std::complex<double>> stiffness_;
  section::Effort effort_;
};

}  // namespace strandyn::damper
