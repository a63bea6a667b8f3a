#pragma once
/// \file When Newton's method has arrived at the end of a time step: one judgement for both integrators.
///
/// It uses the corrections of the current step only. One correction says nothing about the rate: it is enough only
/// where it is a tenth of the tolerance. Later ones are enough at the tolerance, or where their rate promises a tenth
/// of it.

#include "strandyn/system/system.hpp"

namespace strandyn::solver {

/// How many corrections of the next step old factors may serve, after one that took so many. Where two were not enough
/// wires slip, and will go on to: there it pays to take fresh factors sooner.
inline int old_factors_serve(int corrections_before) {
  return corrections_before > 2 ? 1 : 2;
}

enum class Verdict { arrived, on_the_way, lost };

class CorrectionTest {
 public:
  CorrectionTest(double tolerance, std::size_t unknowns);

  /// `iteration` counts from 0 in each attempt of a step.
  Verdict judge(int iteration, const double* correction);
  /// The ten largest entries of the last correction that was not enough, by name.
  std::string worst_unknowns(const model::Model& model) const;

 private:
  double tolerance_;
  double previous_norm_ = 0;
  system::Vector last_;
};

}  // namespace strandyn::solver
