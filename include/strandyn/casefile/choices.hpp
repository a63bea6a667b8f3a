#pragma once
/// \file The words that the span, its loads and the integrator may choose from. Those of the section and of an analysis
/// stand beside their keys; those that other rooms share, in core.

#include "strandyn/conductor/strand.hpp"
#include "strandyn/core/words.hpp"

namespace strandyn::conductor {

constexpr auto words_of(WireShape) {
  return std::array{Named{WireShape::round, "round"}, Named{WireShape::trapezoidal, "trapezoidal"}};
}

}  // namespace strandyn::conductor

namespace strandyn::casefile {

/// `accuracy`: the errors [-] of the dissipation that have a word.
struct NamedError {
  const char* name;
  double value;
};
inline constexpr std::array named_errors = {NamedError{"fast", 0.1}, NamedError{"balanced", 0.02},
                                            NamedError{"reference", 0.002}};
inline constexpr double least_target_error = 1e-4, largest_target_error = 0.5;

using conductor::WireShape;
using strandyn::Control;
using strandyn::Dimension;
using strandyn::MassMatrix;

enum class Grading { clamps, uniform };
constexpr auto words_of(Grading) {
  return std::array{Named{Grading::clamps, "clamps"}, Named{Grading::uniform, "uniform"}};
}

/// Between the ends of a line.
enum class Suspension { pinned, clamped, string };
constexpr auto words_of(Suspension) {
  return std::array{Named{Suspension::pinned, "pinned"}, Named{Suspension::clamped, "clamped"},
                    Named{Suspension::string, "string"}};
}

enum class Support { clamped, pinned, roller, free, guided };
constexpr auto words_of(Support) {
  return std::array{Named{Support::clamped, "clamped"}, Named{Support::pinned, "pinned"},
                    Named{Support::roller, "roller"}, Named{Support::free, "free"}, Named{Support::guided, "guided"}};
}

enum class Method { ida, generalized_alpha };
constexpr auto words_of(Method) {
  return std::array{Named{Method::ida, "ida"}, Named{Method::generalized_alpha, "generalized-alpha"}};
}

enum class StepRule { fixed, automatic, adaptive };
constexpr auto words_of(StepRule) {
  return std::array{Named{StepRule::fixed, "fixed"}, Named{StepRule::automatic, "auto"},
                    Named{StepRule::adaptive, "adaptive"}};
}

}  // namespace strandyn::casefile
