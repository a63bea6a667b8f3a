#pragma once
/// \file What a self-damping study says of its accuracy.

#include "strandyn/self_damping/method.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

/// `error_estimate`: of the point that may be off by most.
struct StudyError {
  double target = 0;
  self_damping::PointError worst{};
  std::string method{};
  double frequency = 0, antinode_amplitude = 0, tension = 0;
  std::size_t above = 0, unknown = 0;  ///< points
};
template <class V>
void members(V& v, StudyError& e) {
  v.part(e.worst);
  v.value("target", e.target, {.what = "that the case asks for"});
  v.value("method", e.method, {.what = "of the point that may be off by most, of which the parts speak"});
  v.value("frequency_Hz", e.frequency, {.what = "of that point, like the next two"});
  v.value("antinode_amplitude_m", e.antinode_amplitude, {.what = "half of peak to peak"});
  v.value("tension_N", e.tension, {.what = "at rest"});
  v.value("points_above_target", e.above, {.what = "that may be off by more than the target"});
  v.value("points_unknown", e.unknown, {.what = "whose error could not be estimated"});
}

/// Nothing where no accuracy was asked for, or no point has numbers that hang on it.
std::optional<StudyError> error_of(const casefile::Scene& scene, const std::vector<self_damping::PointRow>& rows);

/// What is said where the accuracy is not reached at some of so many points.
std::optional<std::string> warning_of(const StudyError& error, std::size_t points);

/// What `describe` tells of the accuracy that is asked for.
struct AccuracyFacts {
  double target = 0;
  std::string chosen;
  std::optional<self_damping::PointChoice> quadrature{}, periodic{}, transient{};
};
template <class V>
void members(V& v, AccuracyFacts& f) {
  v.value("target", f.target, {.what = "of the self-damping"});
  v.value("chosen", f.chosen, {.what = "when the knobs are chosen"});
  v.record("quadrature_begins_with", f.quadrature, {.what = "what a table begins with"});
  v.record("periodic_begins_with", f.periodic, {.what = "what the first periodic point begins with"});
  v.record("transient_begins_with", f.transient, {.what = "what the first test bench begins with"});
}

}  // namespace strandyn::study
