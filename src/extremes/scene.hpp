#pragma once
/// \file A case that is run in memory, for the rows that need a span.

#include <string>
#include <vector>

#include "strandyn/extremes/extreme.hpp"
#include "strandyn/study/run_case.hpp"

namespace strandyn::extremes {

class Run {
 public:
  /// A text of TOML with overrides. Throws what reading and running throw, and ComputationError where the run did not
  /// come to its end: then no bound of physics is worth a word.
  explicit Run(const std::string& text, const std::vector<std::string>& overrides = {});
  explicit Run(const casefile::Scene& scene);

  double at(const std::string& path) const;  ///< a number of the summary, by a path as in [accept]
  const results::Table& table(const std::string& file) const;
  const study::CaseResult& result() const { return result_; }

  /// [-] largest excess, at any step of a transient, of kinetic and elastic energy over what there was at the start and
  /// what has come in, as a part of the largest of both, or of `least_scale` [J] where that is more.
  double energy_above_input(double least_scale = 0) const;
  /// [-] largest deviation of that energy from what came in, over the energy at the start: for what loses nothing.
  double energy_drift() const;

  double evaluations() const { return static_cast<double>(result_.cost.section_evaluations); }
  double steps() const { return static_cast<double>(result_.cost.steps); }

 private:
  study::CaseResult result_;
};

/// Section evaluations of the two runs, `per` what (a step, a cycle, the run).
Cost evaluations(const Run& extreme, const Run& ordinary);
Cost evaluations_per_step(const Run& extreme, const Run& ordinary);

/// Curlew on 10 m between clamps, 15 % RTS, return map, 40 elements; more tables follow.
std::string curlew_span(const std::string& tables);

/// An elastic span of 10 m between pins, T = 4 kN, EI = 10 N m^2, EA = 10 MN, 1 kg/m, in its mode 1 across the line
/// only; more tables follow.
std::string elastic_span(const std::string& tables);

/// Generalized-alpha without numerical damping.
inline const std::string conserving = "method = \"generalized-alpha\"\nrho_inf = 1\n";

}  // namespace strandyn::extremes
